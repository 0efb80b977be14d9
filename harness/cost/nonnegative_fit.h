// SPDX-License-Identifier: Apache-2.0
// Least squares and least absolute errors with weights of at least 0.
#pragma once

#include <span>
#include <vector>

namespace lamina {

// The x >= 0 that makes the sum of (rows[i] . x - targets[i])^2 least. All rows have as many columns; a column of zeros gets 0.
// Throws Error(failed) where there are no rows, or a number is not finite.
// Source: R. Bro, S. de Jong, "A Fast Non-negativity-constrained Least Squares Algorithm", Journal of Chemometrics 11 (1997),
// after C. Lawson, R. Hanson, "Solving Least Squares Problems", 1974, chapter 23.
std::vector<double> fit_nonnegative(std::span<const std::vector<double>> rows, std::span<const double> targets);

// Likewise of the sum of |rows[i] . x - targets[i]|, by least squares whose weights are made again from the errors: errors
// below `small` count by their squares. `ridge`: added to the squared length of every column, which is 1 after scaling, so that
// columns which the rows hardly tell apart share what they explain rather than take it all.
// Source: E. Schlossmacher, "An Iterative Technique for Absolute Deviations Curve Fitting", JASA 68 (1973).
std::vector<double> fit_least_absolute(std::span<const std::vector<double>> rows, std::span<const double> targets, double small,
                                       double ridge);

}  // namespace lamina
