// SPDX-License-Identifier: Apache-2.0
#include "harness/quality/ssim_interior.h"

#include "harness/quality/pixels.h"

namespace lamina {

std::optional<double> ssim_interior(const DisplayImage& test, const DisplayImage& reference) {
  const cv::Mat3d map = ssim_map(test, reference);
  const int width = map.cols - 2 * ssim_border_px, height = map.rows - 2 * ssim_border_px;
  if (width < 1 || height < 1) return std::nullopt;
  const cv::Scalar mean = cv::mean(map(cv::Rect(ssim_border_px, ssim_border_px, width, height)));
  return (mean[0] + mean[1] + mean[2]) / 3;
}

}  // namespace lamina
