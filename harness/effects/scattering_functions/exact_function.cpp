// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/scattering_functions/exact_function.h"

#include <algorithm>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

std::vector<WideReal> widened(Oracle::Point point) { return {point.begin(), point.end()}; }

}  // namespace

std::string ExactOracle::refusal(Point point) const {
  for (const double x : point)
    if (!std::isfinite(x)) return "every input must be a finite number";
  return function_.refusal(point);
}

double ExactOracle::value(Point point) const { return static_cast<double>(function_.value(widened(point))); }

// Central differences with a relative step of 2^-40: what they leave out is below 2^-80.
double ExactOracle::condition(Point point, double value) const {
  if (value == 0) return 0;
  const WideReal step = std::ldexp(1.0, -40), here = function_.value(widened(point));
  WideReal sum = 0;
  for (size_t i = 0; i < point.size(); ++i) {
    std::vector<WideReal> above = widened(point), below = above;
    above[i] *= 1 + step, below[i] *= 1 - step;
    sum += abs((function_.value(above) - function_.value(below)) / (2 * step * here));
  }
  return static_cast<double>(sum);
}

std::vector<std::string> ExactOracle::sets() const {
  std::vector<std::string> names;
  for (const ExactFunction::Set& set : function_.sets) names.push_back(set.name);
  return names;
}

Points ExactOracle::points(const std::string& set, size_t count, uint64_t seed) const {
  const auto found = std::ranges::find(function_.sets, set, &ExactFunction::Set::name);
  if (found == function_.sets.end()) throw Error(ErrorKind::bad_input, "stress", "set", unknown_name("set", set, sets()));
  InputRandom random(seed + static_cast<uint64_t>(found - function_.sets.begin()));
  Points points(function_.inputs.size());
  while (points.size() < count) points.add(found->point(random));
  return points;
}

}  // namespace lamina
