// SPDX-License-Identifier: Apache-2.0
// Where a sampled curve crosses a limit, by linear interpolation, and how far off that may be.
#pragma once

#include <span>
#include <vector>

namespace lamina {

struct Crossing {
  double at = 0;
  // The crossing is within this distance of `at`: where the samples around bend one way, it lies between where the chord and
  // where the neighbours' secants, drawn on, meet the limit (a convex curve is below its chord and above those secants);
  // elsewhere, between its two samples. Holds for a continuous curve that crosses once there and bends as its samples do.
  double tolerance = 0;
  bool rising = false;  // from below the limit to the limit or above
};

// `x` ascending. A `y` that is NaN is not known: no crossing is told beside it. An infinite one has no slope: the crossing is
// then halfway, within half the distance. In ascending order.
std::vector<Crossing> crossings(std::span<const double> x, std::span<const double> y, double limit);

}  // namespace lamina
