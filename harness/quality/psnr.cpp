// SPDX-License-Identifier: Apache-2.0
// Peak signal-to-noise ratio of 8-bit pictures: 10 log10(255^2 / MSE), MSE over r, g, b of the counted pixels. The sum of
// squares is OpenCV's and of integers, so it is exact; OpenCV's own QualityPSNR knows no mask (without one, both agree:
// tests/quality).
#include <cmath>
#include <limits>

#include "harness/quality/pixels.h"

namespace lamina {

double psnr_db(const DisplayImage& test, const DisplayImage& reference, const Mask* mask) {
  check_pair("PSNR", test, reference);
  check_mask("PSNR", mask, test.width, test.height);
  const size_t counted = counted_pixels("PSNR", mask, test.rgb.size() / 3);
  cv::Mat1b on;
  if (mask) on = cv::Mat1b(mask->height, mask->width, const_cast<uint8_t*>(mask->on.data()));
  const double squares = cv::norm(as_mat(test), as_mat(reference), cv::NORM_L2SQR, on);
  if (squares == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(counted) / squares);
}

}  // namespace lamina
