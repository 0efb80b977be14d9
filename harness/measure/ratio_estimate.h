// SPDX-License-Identifier: Apache-2.0
// The ratio of two times from many short strips that were timed beside each other, and how far it can be trusted.
#pragma once

#include <cstddef>
#include <span>

namespace lamina {

// A strip of two frames, ms. Whichever came second met warmer caches.
struct StripPair {
  double before = 0, after = 0;
  bool after_first = false;
};

struct RatioEstimate {
  double log_ratio = 0;  // of after over before
  double error = 0;      // its standard error
  size_t strips = 0;
  double freedom = 1;  // degrees of freedom of that error
};

// Huber's estimate of location of the strips' log ratios, weighted by the harmonic mean of their times (P. J. Huber, "Robust
// estimation of a location parameter", Annals of Mathematical Statistics 35, 1964), its scale the median deviation, with its
// asymptotic standard error: a strip during which something else ran counts as much as one that is a little off, not more, and
// a change of a few strips still counts as a little. Before that, the medians of the strips in either order are brought
// together: what the second of two gains by warm caches is no difference between them. Throws Error(failed) for fewer than
// three strips, or a time that is not positive and finite.
RatioEstimate estimate_ratio(std::span<const StripPair> strips);

// The degrees of freedom of an estimate from so many strips.
double freedom_of(size_t strips);

}  // namespace lamina
