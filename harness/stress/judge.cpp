// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/judge.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double eps = 0x1p-23;

}  // namespace

PointTruth truth_of(const Oracle& oracle, const PointSet& set) {
  PointTruth truth;
  std::vector<double> point;
  for (size_t i = 0; i < set.points.size(); ++i) {
    point.assign(set.points[i].begin(), set.points[i].end());
    const bool known = oracle.refusal(point).empty();
    const double value = known ? oracle.value(point) : std::nan("");
    truth.conditions.push_back(known ? oracle.condition(point, value) : std::nan(""));
    truth.scales.push_back(known ? oracle.scale(point) : std::nan(""));
    truth.values.push_back(i < set.given.size() && !std::isnan(set.given[i]) ? set.given[i] : value);
  }
  return truth;
}

FunctionErrors judge(const Points& points, std::span<const float> values, const PointTruth& truth) {
  FunctionErrors errors;
  errors.worst_over = errors.worst_under = std::vector<double>(points.inputs());
  size_t finite = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const auto point = [&] { return std::vector<double>(points[i].begin(), points[i].end()); };
    const double value = values[i], right = truth.values[i];
    const bool negative = value < 0 && right >= 0, not_zero = right == 0 && value != 0;
    if ((!std::isfinite(value) || negative || not_zero) && !errors.first_fault) errors.first_fault = point();
    if (!std::isfinite(value)) {
      ++errors.nonfinite;
      continue;
    }
    ++finite;
    errors.negative += negative;
    errors.not_zero += not_zero;
    const double difference = value - right, error = difference / truth.scales[i];
    if (error > errors.max_over) errors.max_over = error, errors.worst_over = point();
    if (error < errors.max_under) errors.max_under = error, errors.worst_under = point();
    errors.mean_absolute += std::abs(error);
    errors.rms += error * error;
    errors.max_eps = std::max(errors.max_eps, std::abs(error) / eps);
    if (right != 0)
      errors.max_eps_kappa =
          std::max(errors.max_eps_kappa, std::abs(difference) / std::abs(right) / (eps * std::max(1.0, truth.conditions[i])));
  }
  if (finite > 0) {
    errors.mean_absolute /= static_cast<double>(finite);
    errors.rms = std::sqrt(errors.rms / static_cast<double>(finite));
  }
  return errors;
}

}  // namespace lamina
