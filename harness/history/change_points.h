// SPDX-License-Identifier: Apache-2.0
// Where the level of a series changes for good. Pure functions.
//
// Series with noise: optimal partitioning (Jackson, Scargle et al., "An algorithm for optimal partitioning of data on an
// interval", IEEE Signal Processing Letters 12, 2005) of the series into levels, under the biweight loss of Fearnhead and
// Rigaill, "Changepoint Detection in the Presence of Outliers", Journal of the American Statistical Association 114, 2019: a
// sample costs the square of its distance from its level in standard deviations, but never more than that of an outlier, so
// that samples far off alone make no level of their own. Each level more costs a penalty that grows with log n, as in Killick,
// Fearnhead and Eckley, "Optimal Detection of Changepoints With a Linear Computational Cost", JASA 107, 2012, whose pruning is
// left out: a history has hundreds of records, not millions. O(n^2) levels are tried.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lamina {

// Fewest samples that can show a change; with fewer, noise and change look the same.
inline constexpr size_t min_samples_for_steps = 8;

// Indices of the first sample of each level but the first, ascending. The last sample alone is no change yet: a level of two
// samples is found among at most 12 samples, one of three among at most 115, and later where the samples scatter. The noise is
// estimated from differences of neighbours, of which a change spoils only one. It is never taken below `min_deviation` (0 or
// more; where both are 0, every difference between levels counts). On pure normal noise at most 2% of series of any length have
// a change (tests/history/change_points_test.cpp). Fewer than min_samples_for_steps samples: none. Throws Error(failed) for a
// sample that is not finite.
std::vector<size_t> noisy_steps(std::span<const double> samples, double min_deviation);

// The same for figures without noise, such as counts: the first sample and every later one that differs by more than
// `tolerance` (0 or more) from the first of its level. Infinite samples are equal to each other and differ from all others.
// Throws Error(failed) for NaN.
std::vector<size_t> exact_steps(std::span<const double> samples, double tolerance);

}  // namespace lamina
