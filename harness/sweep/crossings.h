// SPDX-License-Identifier: Apache-2.0
// Where a sampled curve crosses a limit, by linear interpolation, and how far off that may be.
#pragma once

#include <span>
#include <vector>

namespace lamina {

struct Crossing {
  double at = 0;
  // The crossing is within this distance of `at`. Where the samples around it bend one way, it lies between the point where the
  // chord meets the limit and the point where the extended secants of the neighbours do: a convex curve is below its chord and
  // above those secants. Elsewhere it lies between its two samples. This holds for a continuous curve that crosses once there
  // and bends as its samples do.
  double tolerance = 0;
  bool rising = false;  // from below the limit to the limit or above
};

// In ascending order. `x` is ascending. A `y` that is NaN is not known: no crossing is reported next to it. An infinite `y` has
// no slope: the crossing is then halfway, within half the distance.
std::vector<Crossing> crossings(std::span<const double> x, std::span<const double> y, double limit);

}  // namespace lamina
