// SPDX-License-Identifier: Apache-2.0
// All figures of one comparison, over the covered pixels and over the frame. Maps are made once and pooled twice.
#include <tbb/parallel_invoke.h>

#include "harness/quality/pixels.h"

namespace lamina {

ErrorReport measure_error(const Image& test, const Image& reference, const Mask& covered) {
  check_pair("comparison", test, reference);
  check_mask("comparison", &covered, test.width, test.height);
  counted_pixels("comparison", &covered, test.rgba.size() / 4);
  check_finite("comparison", test, "test");
  check_finite("comparison", reference, "reference");

  const DisplayImage shown = to_display(test), shown_reference = to_display(reference);
  ErrorReport report;
  cv::Mat3d similarity;
  tbb::parallel_invoke([&] { similarity = ssim_map(shown, shown_reference); },
                       [&] { report.flip = flip_map(shown, shown_reference); });
  const auto figures_over = [&](const Mask* mask) {
    return ErrorFigures{.psnr_db = psnr_db(shown, shown_reference, mask),
                        .ssim = ssim_mean(similarity, mask),
                        .flip = flip_mean(report.flip, mask),
                        .rmse_linear = rmse_linear(test, reference, mask),
                        .max_linear = max_linear(test, reference, mask)};
  };
  report.covered = figures_over(&covered);
  report.frame = figures_over(nullptr);
  return report;
}

}  // namespace lamina
