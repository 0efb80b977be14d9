// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/time_verdicts.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace lamina {
namespace {

struct Claim {
  Verdict verdict = Verdict::ambiguous;
  double chance = 1;  // of claiming it by luck, both sides together
};

Claim strongest_claim(const RatioEstimate& ratio, double margin) {
  const double edge = std::log1p(margin);
  // The chance of lying this far beyond the edge, `beyond` being log ratios.
  const auto chance = [&](double beyond) {
    if (ratio.error == 0) return beyond > 0 ? 0.0 : 1.0;
    return boost::math::cdf(boost::math::complement(boost::math::students_t(ratio.freedom), beyond / ratio.error));
  };
  const double slower = chance(ratio.log_ratio - edge), faster = chance(-ratio.log_ratio - edge);
  Claim claim{Verdict::same, std::max(chance(edge - ratio.log_ratio), chance(edge + ratio.log_ratio))};
  if (slower < claim.chance) claim = {Verdict::slower, slower};
  if (faster < claim.chance) claim = {Verdict::faster, faster};
  claim.chance = std::min(1.0, 2 * claim.chance);
  return claim;
}

}  // namespace

Interval ratio_interval(const RatioEstimate& ratio, double confidence) {
  const double reach = ratio.error * boost::math::quantile(boost::math::students_t(ratio.freedom), 1 - (1 - confidence) / 2);
  return {std::exp(ratio.log_ratio), std::exp(ratio.log_ratio - reach), std::exp(ratio.log_ratio + reach), ratio.strips,
          confidence};
}

std::vector<TimeVerdict> judge_times(std::span<const TimeComparison> comparisons, const SharedDisagreement& shared,
                                     double family_error) {
  std::vector<RatioEstimate> ratios;
  std::vector<Claim> claims;
  for (const TimeComparison& comparison : comparisons) {
    ratios.push_back(settle(pool(comparison.processes), shared));
    claims.push_back(strongest_claim(ratios.back(), comparison.margin));
  }
  std::vector<size_t> order(comparisons.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return claims[a].chance < claims[b].chance; });
  std::vector<TimeVerdict> verdicts(comparisons.size());
  bool decided = true;
  for (size_t k = 0; k < order.size(); ++k) {
    const double error = family_error / static_cast<double>(order.size() - k);
    const size_t i = order[k];
    decided = decided && claims[i].chance <= error;
    verdicts[i].verdict = decided ? claims[i].verdict : Verdict::ambiguous;
    verdicts[i].ratio = ratio_interval(ratios[i], 1 - error);
  }
  return verdicts;
}

}  // namespace lamina
