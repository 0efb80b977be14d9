// SPDX-License-Identifier: Apache-2.0
// Least squares with weights of at least 0.
#pragma once

#include <span>
#include <vector>

namespace lamina {

// The x >= 0 that makes the sum of (rows[i] . x - 1)^2 least: each row is divided by what it should give, so that errors are
// relative. All rows have as many columns; a column of zeros gets 0. One coordinate after another is set to its best value
// until none moves by more than 1e-10 of the largest: V. Franc, V. Hlavac, M. Navara, "Sequential Coordinate-Wise Algorithm for
// the Non-negative Least Squares Problem", CAIP 2005. Throws Error(failed) where there are no rows, or a number is not finite.
std::vector<double> fit_nonnegative(std::span<const std::vector<double>> rows);

}  // namespace lamina
