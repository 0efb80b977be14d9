// SPDX-License-Identifier: Apache-2.0
// The curves of a sweep, drawn from its record: how each variant's errors and cost move along one parameter, the others held.
// Costs are ratios to the baseline at the same point, so that curves of several machines can be joined.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "harness/record/record.h"

namespace lamina {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What a curve can show. Errors are those of the worst view, over the pixels that the effect covers.
struct Metric {
  const char* name;                        // "ssim"; "truth.ssim" against the truth
  const char* words;                       // "SSIM"
  bool more_is_better;                     // ratio: less
  double ErrorFigures::*figure = nullptr;  // null: the ratio
};
inline constexpr std::array<Metric, 11> metrics = {
    {{"ssim", "SSIM", true, &ErrorFigures::ssim},
     {"psnr_db", "PSNR in dB", true, &ErrorFigures::psnr_db},
     {"flip", "FLIP", false, &ErrorFigures::flip},
     {"rmse_linear", "RMSE", false, &ErrorFigures::rmse_linear},
     {"max_linear", "the greatest difference", false, &ErrorFigures::max_linear},
     {"truth.ssim", "SSIM to the truth", true, &ErrorFigures::ssim},
     {"truth.psnr_db", "PSNR to the truth in dB", true, &ErrorFigures::psnr_db},
     {"truth.flip", "FLIP to the truth", false, &ErrorFigures::flip},
     {"truth.rmse_linear", "RMSE to the truth", false, &ErrorFigures::rmse_linear},
     {"truth.max_linear", "the greatest difference to the truth", false, &ErrorFigures::max_linear},
     // Geometric mean over views of the ratios' medians.
     {"ratio", "time over the baseline's", false}}};
const Metric* metric_named(std::string_view name);

// A parameter of a grid that a curve does not run along, and its value there.
struct Held {
  std::string path, unit;
  double value = 0;
  bool operator==(const Held&) const = default;
};

struct Curve {
  std::string backend, effect, variant;
  bool baseline = false;
  std::string parameter, unit;  // along x
  std::vector<Held> held;
  std::vector<double> x;  // ascending
  // By metric; NaN where a view has none or failed. "ratio.low" and "ratio.high" are the ends of the ratio's interval.
  std::map<std::string, std::vector<double>> y;
};
// Whether they are variants' curves over the same: one backend, effect, parameter, and the others held at the same values.
bool in_one_group(const Curve& a, const Curve& b);

// By backend, effect, parameter and what is held, in the order of the record, each with its variants, the baseline first. Of
// zipped parameters the first is x. Parameters of one value have no curve. None for a record without a sweep.
std::vector<Curve> curves_of(const Record& record);

}  // namespace lamina
