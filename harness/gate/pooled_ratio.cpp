// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/pooled_ratio.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "harness/core/error.h"
#include "harness/measure/statistics.h"

namespace lamina {
namespace {

using boost::math::digamma, boost::math::trigamma;

constexpr double min_variance = 1e-18;     // so that exact times can be pooled
constexpr double cautious = 0.25;          // chance that comparisons differ more than is supposed
constexpr double min_disagreement = 0.01;  // of the median: processes that agree by luck have a logarithm near minus infinity

// By Newton's method on 1 / trigamma, which is convex (Smyth, appendix).
double inverse_trigamma(double value) {
  double x = 0.5 + 1 / value;
  for (int step = 0; step < 50; ++step) {
    const double here = trigamma(x), move = here * (1 - here / value) / boost::math::polygamma(2, x);
    x += move;
    if (std::abs(move) < 1e-9 * x) break;
  }
  return x;
}

}  // namespace

PooledRatio pool(std::span<const RatioEstimate> processes) {
  if (processes.empty()) throw Error(ErrorKind::failed, "gate", "time", "there are no rounds to judge by");
  std::vector<double> variances;
  for (const RatioEstimate& each : processes) {
    if (!std::isfinite(each.log_ratio) || !std::isfinite(each.error))
      throw Error(ErrorKind::failed, "gate", "time", "a ratio of times is not finite, which is no measurement");
    variances.push_back(each.error * each.error);
  }
  const double middle = std::max(median(variances), min_variance);
  const auto weight = [&](size_t i) { return 1 / std::max(variances[i], middle); };
  PooledRatio pooled;
  pooled.within_freedom = 0;
  double weights = 0, squares = 0, fourths = 0;
  for (size_t i = 0; i < processes.size(); ++i) {
    pooled.log_ratio += weight(i) * processes[i].log_ratio;
    pooled.strips += processes[i].strips, pooled.within_freedom += processes[i].freedom;
    weights += weight(i), squares += std::pow(weight(i), 2), fourths += std::pow(weight(i), 4);
  }
  pooled.log_ratio /= weights;
  pooled.within = 1 / weights;
  if (processes.size() < 2) return pooled;
  const double count = static_cast<double>(processes.size()), few = count / (count - 1);
  double scatter = 0;
  for (size_t i = 0; i < processes.size(); ++i) scatter += std::pow(weight(i) * (processes[i].log_ratio - pooled.log_ratio), 2);
  pooled.disagreement = few * scatter / weights;  // over weights^2, and over 1 / weights
  pooled.disagreement_freedom = squares * squares / fourths / few;
  return pooled;
}

SharedDisagreement shared_disagreement(std::span<const PooledRatio> comparisons) {
  std::vector<double> disagreements, freedoms;
  for (const PooledRatio& each : comparisons)
    if (each.disagreement_freedom > 0)
      disagreements.push_back(each.disagreement), freedoms.push_back(each.disagreement_freedom);
  const auto count = static_cast<double>(freedoms.size());
  if (count < 2) return {};
  const double least = std::max(min_disagreement * median(disagreements), std::numeric_limits<double>::min());
  std::vector<double> logs;  // their mean is that of the logarithm of what is typical, up to its own freedom
  double mean = 0, by_chance = 0, freedom = 0;
  for (size_t i = 0; i < freedoms.size(); ++i) {
    const double half = freedoms[i] / 2;
    logs.push_back(std::log(std::max(disagreements[i], least)) - digamma(half) + std::log(half));
    mean += logs.back() / count, by_chance += trigamma(half) / count, freedom += freedoms[i];
  }
  double spread = 0;
  for (const double log : logs) spread += std::pow(log - mean, 2) / (count - 1);
  // A few comparisons may be alike by luck, so a larger spread is assumed than they show.
  spread *= (count - 1) / boost::math::quantile(boost::math::chi_squared(count - 1), cautious);
  const double of_others = freedom * (count - 1) / count;
  if (spread <= by_chance) return {std::exp(mean), of_others};
  const double half = inverse_trigamma(spread - by_chance);
  return {std::exp(mean + digamma(half) - std::log(half)), std::min(2 * half, of_others)};
}

RatioEstimate settle(const PooledRatio& pooled, const SharedDisagreement& others) {
  RatioEstimate ratio{pooled.log_ratio, std::sqrt(pooled.within), pooled.strips, pooled.within_freedom};
  const double freedom = pooled.disagreement_freedom + others.freedom;
  if (freedom == 0) return ratio;
  const double own = pooled.disagreement_freedom * pooled.disagreement / freedom;
  const double whole = std::max(1.0, own + others.freedom * others.typical / freedom), rest = whole - own;
  ratio.error = std::sqrt(pooled.within * whole);
  // `own` times `within` is the scatter itself; of the rest `within` is a factor, with an error of its own.
  ratio.freedom = 1 / (1 / freedom + rest * rest / (whole * whole * pooled.within_freedom));
  return ratio;
}

}  // namespace lamina
