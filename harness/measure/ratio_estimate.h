// SPDX-License-Identifier: Apache-2.0
// The ratio of two times, and its standard error, from many short strips that were timed beside each other.
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

// Huber's estimate of location of the strips' log ratios (P. J. Huber, "Robust estimation of a location parameter", Annals of
// Mathematical Statistics 35, 1964), weighted by the harmonic mean of their times, with the median deviation as its scale and
// with its asymptotic standard error. A strip during which something else ran then counts no more than one that is a little
// off, and a change of a few strips still counts a little. Strips that ran first and strips that ran second are first shifted
// to one median: the advantage of warm caches is no difference between the frames. Throws Error(failed) for fewer than three
// strips, or a time that is not positive and finite.
RatioEstimate estimate_ratio(std::span<const StripPair> strips);

// The degrees of freedom of an estimate from so many strips.
double freedom_of(size_t strips);

}  // namespace lamina
