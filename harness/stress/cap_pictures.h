// SPDX-License-Identifier: Apache-2.0
// Pictures of a cap intersection's error over slices of its inputs.
#pragma once

#include <filesystem>
#include <string>

#include "harness/stress/cap_stress.h"

namespace lamina {

// A slice: r1 is fixed; r0 runs from 0 to pi to the right, d from 0 to pi upwards.
struct CapSlice {
  float r1 = 0;
  std::vector<CapInput> inputs;  // a pixel each, row 0 on top
  std::vector<double> truth;     // beside inputs: cap_intersection_area()
};
// For r1 = 0.1, 0.5, 1 and 1.5.
std::vector<CapSlice> make_cap_slices();

// Writes FOLDER/NAME-r1-X.png for each slice and returns these files' names, beside the slices. Red is an area too large, blue
// too small, white none; full colour at `full_error` of the smaller cap; black is not finite.
inline constexpr double full_error = 0.16;
std::vector<std::string> write_cap_pictures(CapRunner& runner, std::span<const CapSlice> slices,
                                            const std::filesystem::path& folder, const std::string& name);

}  // namespace lamina
