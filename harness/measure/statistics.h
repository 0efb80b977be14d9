// SPDX-License-Identifier: Apache-2.0
// Statistics of samples: pure functions, no clock.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lamina {

// Mean of the two middle values for an even count. Throws Error(failed) for no samples, or one that is not finite.
double median(std::span<const double> samples);

struct Interval {
  double median = 0, low = 0, high = 0;
  size_t rounds = 0;
  double coverage = 0;  // the interval's true confidence, at least the one asked for
};

// Smallest number of samples that can give a 95% interval of a median: 6 (1 - 2 / 2^6 = 0.969).
inline constexpr size_t min_rounds_for_95 = 6;

// Distribution-free interval of the median from order statistics (David and Nagaraja, "Order Statistics", 3rd ed. 2003, section
// 7.1): the narrowest symmetric pair x(k), x(n+1-k) whose binomial coverage is at least `confidence` (between 0 and 1).
// Throws as median() does, and where n samples cannot reach the confidence.
Interval median_interval(std::span<const double> samples, double confidence = 0.95);

// The same, but where the samples cannot reach the confidence, the whole range, whose coverage says so. Throws as median()
// does, and for a confidence that is not between 0 and 1.
Interval widest_interval(std::span<const double> samples, double confidence);

// The interval of the median of a[i] / b[i]: paired by round. Throws on unequal counts, or a b[i] that is not positive.
Interval ratio_interval(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

}  // namespace lamina
