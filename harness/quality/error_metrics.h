// SPDX-License-Identifier: Apache-2.0
// The figures that may stand for the error, by the names that records and options have for them.
#pragma once

#include <array>
#include <string_view>

#include "harness/quality/quality.h"

namespace lamina {

// In the order of the page's data.
struct ErrorMetric {
  const char *name, *words;  // the record's field; for people
  bool more_is_closer;
  double ErrorFigures::*figure;
};
inline constexpr std::array<ErrorMetric, 5> error_metrics = {
    {{"ssim", "SSIM", true, &ErrorFigures::ssim},
     {"psnr_db", "PSNR, dB", true, &ErrorFigures::psnr_db},
     {"flip", "FLIP", false, &ErrorFigures::flip},
     {"max_linear", "max, linear", false, &ErrorFigures::max_linear},
     {"rmse_linear", "RMSE, linear", false, &ErrorFigures::rmse_linear}}};

// Null where no metric has this name.
inline const ErrorMetric* error_metric(std::string_view name) {
  for (const ErrorMetric& metric : error_metrics)
    if (name == metric.name) return &metric;
  return nullptr;
}

}  // namespace lamina
