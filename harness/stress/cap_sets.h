// SPDX-License-Identifier: Apache-2.0
// Inputs for the cap intersections: a box of everyday ones, and sets of hard ones.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

// Radii in (0, pi], distance in [0, pi], radians; binary32, as the shaders take them.
struct CapInput {
  float r0 = 0, r1 = 0, d = 0;
};

struct CapSet {
  std::string name, what;
  std::vector<CapInput> inputs;
  std::vector<double> areas;  // given by a file, beside inputs; else empty
};

// `count` inputs in each set, the same for the same seed:
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
std::vector<CapSet> make_cap_sets(size_t count, uint64_t seed);

// One set, "grid": `steps` values each of r0 and r1, evenly in (0, pi), and of d, evenly in [0, pi] with both ends. From 2
// steps.
CapSet make_cap_grid(size_t steps);

// One set from a file of comma-separated r0,r1,d[,area[,...]]; lines that are empty or begin with # are left out, and so is a
// first line of names. Throws Error(bad_input) naming file and line for what is no number or out of range. Values are rounded
// to binary32.
CapSet read_cap_points(const std::filesystem::path& file);

}  // namespace lamina
