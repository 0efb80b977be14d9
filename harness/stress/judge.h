// SPDX-License-Identifier: Apache-2.0
// Errors of a function's values, against an oracle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/stress/oracle.h"

namespace lamina {

// For each point of a set: the exact value (the one in the file of points where it gives one), the condition
// number, and what errors are divided by. All are NaN at a point that the oracle refuses.
struct PointTruth {
  std::vector<double> values, conditions, scales;
};
PointTruth truth_of(const Oracle& oracle, const PointSet& set);

// Errors are (value - truth) / scale, unless they say otherwise. Points are inputs in the function's order.
struct FunctionErrors {
  double max_over = 0, max_under = 0;  // greatest and least, so 0 or more and 0 or less
  double mean_absolute = 0, rms = 0;
  std::vector<double> worst_over, worst_under;
  double max_eps = 0;        // greatest |error| in units of 2^-23
  double max_eps_kappa = 0;  // greatest |(value - truth) / truth| in units of 2^-23 max(1, condition), where the truth is not 0
  size_t negative = 0;       // where the truth is not
  size_t nonfinite = 0;
  size_t not_zero = 0;                             // where the truth is 0
  std::optional<std::vector<double>> first_fault;  // the first point of these three
};
// Points, values and truth beside each other. What is not finite is counted and in no other figure.
FunctionErrors judge(const Points& points, std::span<const float> values, const PointTruth& truth);

}  // namespace lamina
