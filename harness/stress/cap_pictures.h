// SPDX-License-Identifier: Apache-2.0
// Pictures of a cap intersection's error over slices of its inputs.
#pragma once

#include <filesystem>
#include <string>

#include "harness/stress/cap_stress.h"

namespace lamina {

// Writes FOLDER/NAME-r1-X.png for r1 = 0.1, 0.5, 1 and 1.5: r0 from 0 to pi to the right, d from 0 to pi upwards. Red is an
// area too large, blue too small, white none; full colour at `full_error` of the smaller cap; black is not finite.
inline constexpr double full_error = 0.16;
void write_cap_pictures(CapRunner& runner, const std::filesystem::path& folder, const std::string& name);

}  // namespace lamina
