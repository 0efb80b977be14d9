// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "harness/core/error.h"

namespace lamina {
namespace {

[[noreturn]] void refuse(std::string subject, std::string message) {
  throw Error(ErrorKind::failed, "measure", std::move(subject), std::move(message));
}

// NaN has no place in an order, and an infinite time or ratio is a failure of the clock.
std::vector<double> sorted(std::span<const double> samples) {
  if (samples.empty()) refuse("median", "there are no samples; measure at least one round");
  for (size_t i = 0; i < samples.size(); ++i)
    if (!std::isfinite(samples[i])) refuse("median", fmt::format("sample {} is {}, which is no measurement", i, samples[i]));
  std::vector<double> in_order(samples.begin(), samples.end());
  std::ranges::sort(in_order);
  return in_order;
}

double middle(const std::vector<double>& in_order) {
  return std::midpoint(in_order[(in_order.size() - 1) / 2], in_order[in_order.size() / 2]);
}

}  // namespace

double median(std::span<const double> samples) { return middle(sorted(samples)); }

// The count of samples below the true median is binomial(n, 1/2), and x(k) <= median <= x(n+1-k) exactly when it lies in k ..
// n-k. So the coverage is a sum of binomial probabilities, grown here from the middle outwards until it is enough, or all.
Interval widest_interval(std::span<const double> samples, double confidence) {
  if (!(confidence > 0 && confidence < 1))
    refuse("median interval", fmt::format("a confidence of {} is not between 0 and 1", confidence));
  const std::vector<double> in_order = sorted(samples);
  const size_t n = in_order.size();

  size_t k = (n + 1) / 2;
  // Probability of the middle count: C(2m, m) / 4^m, the product of (2j - 1) / 2j, also for odd n = 2m - 1, where C(2m - 1, m)
  // / 2^(2m - 1) is the same number. A product, since factorials overflow.
  double probability = 1;
  for (size_t j = 1; j <= k; ++j) probability *= static_cast<double>(2 * j - 1) / static_cast<double>(2 * j);
  double coverage = n % 2 == 0 ? probability : 0;  // an odd count's innermost pair is the middle sample itself
  while (coverage < confidence && k > 1) {
    // From count k to k - 1: C(n, k - 1) = C(n, k) k / (n - k + 1). From an odd count's middle that factor is 1.
    probability *= static_cast<double>(k) / static_cast<double>(n - k + 1);
    --k;
    coverage += 2 * probability;
  }
  return {.median = middle(in_order), .low = in_order[k - 1], .high = in_order[n - k], .rounds = n, .coverage = coverage};
}

Interval median_interval(std::span<const double> samples, double confidence) {
  const Interval interval = widest_interval(samples, confidence);
  if (interval.coverage < confidence)
    refuse("median interval", fmt::format("{} samples give at most {:.4f} confidence, {} was asked for; measure more rounds",
                                          interval.rounds, interval.coverage, confidence));
  return interval;
}

Interval ratio_interval(std::span<const double> a, std::span<const double> b, double confidence) {
  if (a.size() != b.size())
    refuse("ratio",
           fmt::format("{} samples over {}: ratios are paired by round, so measure both in every round", a.size(), b.size()));
  std::vector<double> ratios(a.size());
  for (size_t i = 0; i < a.size(); ++i) {
    if (!(b[i] > 0)) refuse("ratio", fmt::format("the divisor of round {} is {}, which is not positive", i, b[i]));
    ratios[i] = a[i] / b[i];
  }
  return median_interval(ratios, confidence);
}

}  // namespace lamina
