// SPDX-License-Identifier: Apache-2.0
// Inputs for the cap intersections, r0, r1, d: a box of everyday ones, and sets of hard ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/stress/points.h"

namespace lamina {

//   overlaps        a regular grid: r1 <= r0 <= pi/2, d evenly from contained to apart; somewhat fewer than `count`
//   box             r0, r1 uniform in (0, pi/2], d uniform in [0, pi]: where the approximations are meant to be used
//   large           r0, r1 uniform in (0, pi), d uniform in [0, pi]
//   tiny            radii of 1e-6 to 1e-3, spaced evenly in the logarithm, overlapping
//   tangent_outside d just below r0 + r1
//   tangent_inside  d just above |r0 - r1|
//   equal           r0 and r1 equal or a few units in the last place apart
//   hemispheres     both radii within 1e-6 to 1e-2 of pi/2
//   nearly_whole    r0 within 1e-5 to 1e-1 of pi, r1 as small, across the edge of what r0 leaves out
//   covering        r0 + r1 + d just below 2 pi
std::vector<std::string> cap_set_names();

// `count` inputs of a set, the same for the same seed.
Points make_cap_points(const std::string& set, size_t count, uint64_t seed);

}  // namespace lamina
