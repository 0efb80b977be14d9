// SPDX-License-Identifier: Apache-2.0
// Sets of inputs for a family: those that its oracle makes, an even grid, or what a person gives in a file.
#pragma once

#include <filesystem>

#include "harness/stress/family.h"

namespace lamina {

// Every set that the family declares, with about `count` points each.
std::vector<PointSet> make_sets(const Family& family, size_t count, uint64_t seed);

inline constexpr size_t max_grid_points = 160 * 160 * 160;
// One set, "grid": `steps` values of each input, evenly over its range, an end included unless it is open; the last input runs
// fastest. Points that the oracle refuses are left out. Throws Error(bad_input, "stress", "--grid N", ...) for fewer than 2
// steps, more than max_grid_points, and where no point is left.
PointSet make_grid(const Family& family, size_t steps);

// One set, "points", from a file of comma-separated inputs, a line each, which may have the right value behind them and
// whatever else behind that; lines that are empty or begin with # are left out, and so is a first line of names. Throws
// Error(bad_input) naming file and line for what is no number or what the oracle refuses. Inputs are rounded to binary32.
PointSet read_points(const Family& family, const std::filesystem::path& file);

}  // namespace lamina
