// SPDX-License-Identifier: Apache-2.0
// Structural similarity of 8-bit sRGB pictures, each of r, g and b by itself.
// Source: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
// Transactions on Image Processing 13(4), 2004, sections III.B and III.C; computed by OpenCV's QualitySSIM.
// Limits: the 11x11 window mirrors the picture at its border without repeating the edge pixel (the paper leaves the border
// out), and at a mask's edge it also sees pixels that are not counted.
#include <opencv2/core/ocl.hpp>
#include <opencv2/quality/qualityssim.hpp>

#include "harness/quality/pixels.h"

namespace lamina {
namespace {

constexpr int window_radius = 5;  // of 11x11 pixels

}  // namespace

cv::Mat3d ssim_map(const DisplayImage& test, const DisplayImage& reference) {
  check_pair("SSIM", test, reference);
  cv::Mat3d map(test.height, test.width, cv::Vec3d::all(1));  // of equal windows
  const DifferingPart part = differing_part(test, reference, window_radius);
  if (part.changed.empty()) return map;
  cv::ocl::setUseOpenCL(false);  // QualitySSIM would run on a GPU where it finds one, with other rounding there
  // QualitySSIM works in float on 8-bit pictures and in double on float ones; its variances are differences of large numbers.
  cv::Mat test_float, reference_float;
  as_mat(test)(part.read).convertTo(test_float, CV_32F);
  as_mat(reference)(part.read).convertTo(reference_float, CV_32F);
  cv::Mat3d made;
  cv::quality::QualitySSIM::compute(reference_float, test_float, made);
  made(part.changed - part.read.tl()).copyTo(map(part.changed));
  return map;
}

double ssim_mean(const cv::Mat3d& map, const Mask* mask) {
  check_mask("SSIM", mask, map.cols, map.rows);
  const size_t counted = counted_pixels("SSIM", mask, map.total());
  double sum = 0;
  size_t pixel = 0;
  for (const cv::Vec3d& value : map)
    if (counts(mask, pixel++)) sum += value[0] + value[1] + value[2];
  return sum / (3 * static_cast<double>(counted));
}

double ssim(const DisplayImage& test, const DisplayImage& reference, const Mask* mask) {
  return ssim_mean(ssim_map(test, reference), mask);
}

}  // namespace lamina
