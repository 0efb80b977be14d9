// SPDX-License-Identifier: Apache-2.0
#include "harness/stress/formula_oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

std::vector<Real> real_point(Oracle::Point point) { return {point.begin(), point.end()}; }

}  // namespace

double of_one(double) { return 1; }

double of_value(double value) { return std::max(std::abs(value), 1e-36); }

double SetRandom::logarithmic(double low, double high) { return low * std::exp(uniform(0, 1) * std::log(high / low)); }

std::string FormulaOracle::refusal(Point point) const {
  const bool finite = std::ranges::all_of(point, [](double x) { return std::isfinite(x); });
  return finite && formula_.accepts(point) ? "" : formula_.refusal;
}

double FormulaOracle::value(Point point) const { return static_cast<double>(formula_.value(real_point(point))); }

double FormulaOracle::condition(Point point, double value) const {
  if (value == 0) return 0;
  std::vector<Real> at = real_point(point);
  const Real middle = formula_.value(at);
  Real sum = 0;
  for (Real& x : at) {
    const Real kept = x, step = abs(kept) * Real(1e-25) + Real(1e-40);
    x = kept - step;  // towards the inside of every range
    if (kept <= 0) x = kept + step;
    sum += abs(kept * (formula_.value(at) - middle) / step);
    x = kept;
  }
  return static_cast<double>(sum / abs(middle));
}

std::vector<std::string> FormulaOracle::sets() const {
  std::vector<std::string> names;
  for (const Formula::Set& set : formula_.sets) names.push_back(set.name);
  return names;
}

Points FormulaOracle::points(const std::string& set, size_t count, uint64_t seed) const {
  const auto found = std::ranges::find(formula_.sets, set, &Formula::Set::name);
  if (found == formula_.sets.end()) throw Error(ErrorKind::bad_input, "stress", "set", unknown_name("set", set, sets()));
  SetRandom random(seed + static_cast<uint64_t>(found - formula_.sets.begin()));
  Points points(formula_.inputs.size());
  for (size_t i = 0; i < count; ++i) {
    const std::vector<double> drawn = found->point(random);
    const std::vector<float> single(drawn.begin(), drawn.end());
    points.add(single);
  }
  return points;
}

}  // namespace lamina
