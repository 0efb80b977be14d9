// SPDX-License-Identifier: Apache-2.0
// The box around all differing pixels. Variants differ from their baseline on an object, and the rest of a frame is the same.
#include <opencv2/imgproc.hpp>

#include "harness/quality/pixels.h"

namespace lamina {
namespace {

cv::Rect grown(const cv::Rect& box, int radius, const cv::Size& picture) {
  return cv::Rect(box.x - radius, box.y - radius, box.width + 2 * radius, box.height + 2 * radius) & cv::Rect({0, 0}, picture);
}

}  // namespace

DifferingPart differing_part(const DisplayImage& test, const DisplayImage& reference, int radius) {
  check_pair("differing part", test, reference);
  cv::Mat difference;
  cv::absdiff(as_mat(test), as_mat(reference), difference);
  const cv::Rect channels = cv::boundingRect(difference.reshape(1));  // three a pixel
  if (channels.empty()) return {};
  const int left = channels.x / 3, right = (channels.x + channels.width + 2) / 3;
  const cv::Size size(test.width, test.height);
  const cv::Rect changed = grown({left, channels.y, right - left, channels.height}, radius, size);
  return {changed, grown(changed, radius, size)};
}

}  // namespace lamina
