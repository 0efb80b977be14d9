// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/time_verdicts.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numeric>

#include "harness/core/error.h"

namespace lamina {
namespace {

// The chance that of n fair coins at least k fall heads.
double sign_test(size_t n, size_t k) {
  if (k == 0) return 1;
  const boost::math::binomial coins(static_cast<double>(n), 0.5);
  return boost::math::cdf(boost::math::complement(coins, static_cast<double>(k - 1)));
}

struct Claim {
  Verdict verdict = Verdict::ambiguous;
  double chance = 1;  // of claiming it by luck, both sides together
};

bool lies_in(Verdict region, double ratio, double margin) {
  if (region == Verdict::slower) return ratio > 1 + margin;
  if (region == Verdict::faster) return ratio < 1 / (1 + margin);
  return ratio <= 1 + margin && ratio >= 1 / (1 + margin);
}

Claim strongest_claim(const TimeComparison& comparison, const std::vector<double>& ratios) {
  const size_t n = ratios.size();
  const auto count = [&](auto&& holds) { return static_cast<size_t>(std::count_if(ratios.begin(), ratios.end(), holds)); };
  const double high = 1 + comparison.margin, low = 1 / high;
  const double slower = sign_test(n, count([&](double ratio) { return ratio > high; }));
  const double faster = sign_test(n, count([&](double ratio) { return ratio < low; }));
  const double same = std::max(sign_test(n, count([&](double ratio) { return ratio <= high; })),
                               sign_test(n, count([&](double ratio) { return ratio >= low; })));
  Claim claim{Verdict::same, same};
  if (slower < claim.chance) claim = {Verdict::slower, slower};
  if (faster < claim.chance) claim = {Verdict::faster, faster};
  claim.chance = std::min(1.0, 2 * claim.chance);
  for (const std::vector<double>& process : comparison.ratios)
    if (!process.empty() && !lies_in(claim.verdict, median(process), comparison.margin)) claim.chance = 1;
  return claim;
}

std::vector<double> all_ratios(const TimeComparison& comparison) {
  std::vector<double> ratios;
  for (const std::vector<double>& process : comparison.ratios) ratios.insert(ratios.end(), process.begin(), process.end());
  for (const double ratio : ratios)
    if (!(ratio > 0) || !std::isfinite(ratio))
      throw Error(ErrorKind::failed, "gate", "time", fmt::format("a ratio of times is {}, which is no measurement", ratio));
  if (ratios.empty()) throw Error(ErrorKind::failed, "gate", "time", "there are no rounds to judge by");
  return ratios;
}

}  // namespace

std::vector<TimeVerdict> judge_times(std::span<const TimeComparison> comparisons, double family_error) {
  std::vector<std::vector<double>> ratios;
  std::vector<Claim> claims;
  for (const TimeComparison& comparison : comparisons) {
    ratios.push_back(all_ratios(comparison));
    claims.push_back(strongest_claim(comparison, ratios.back()));
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
    verdicts[i].ratio = widest_interval(ratios[i], 1 - error);
  }
  return verdicts;
}

double worst_precision(std::span<const TimeComparison> comparisons, std::span<const TimeVerdict> verdicts) {
  double worst = 0;
  for (size_t i = 0; i < comparisons.size(); ++i)
    worst = std::max(worst, (verdicts[i].ratio.high - verdicts[i].ratio.low) / 2 / comparisons[i].margin);
  return worst;
}

}  // namespace lamina
