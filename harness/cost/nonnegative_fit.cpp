// SPDX-License-Identifier: Apache-2.0
#include "harness/cost/nonnegative_fit.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"

namespace lamina {

std::vector<double> fit_nonnegative(std::span<const std::vector<double>> rows) {
  if (rows.empty()) throw Error(ErrorKind::failed, "cost model", "fit", "there is nothing to fit to");
  const size_t columns = rows.front().size();
  for (const std::vector<double>& row : rows)
    if (row.size() != columns || !std::ranges::all_of(row, [](double value) { return std::isfinite(value); }))
      throw Error(ErrorKind::failed, "cost model", "fit", "a row has another length, or holds what is not a finite number");

  // Columns are scaled to one length, so that one step size fits all. gradient = A^T A x - A^T 1.
  std::vector<double> scale(columns, 0), gradient(columns, 0), x(columns, 0);
  for (const std::vector<double>& row : rows)
    for (size_t j = 0; j < columns; ++j) scale[j] += row[j] * row[j];
  for (double& length : scale) length = std::sqrt(length);
  std::vector<std::vector<double>> normal(columns, std::vector<double>(columns, 0));
  for (const std::vector<double>& row : rows)
    for (size_t j = 0; j < columns; ++j) {
      if (scale[j] == 0) continue;
      gradient[j] -= row[j] / scale[j];
      for (size_t k = 0; k < columns; ++k)
        if (scale[k] > 0) normal[j][k] += row[j] * row[k] / (scale[j] * scale[k]);
    }
  constexpr int max_sweeps = 20000;
  constexpr double small = 1e-10;
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double moved = 0, largest = 0;
    for (size_t j = 0; j < columns; ++j) {
      if (scale[j] == 0) continue;
      const double step = std::max(0.0, x[j] - gradient[j]) - x[j];  // normal[j][j] is 1
      if (step != 0)
        for (size_t k = 0; k < columns; ++k) gradient[k] += step * normal[j][k];
      x[j] += step;
      moved = std::max(moved, std::abs(step)), largest = std::max(largest, x[j]);
    }
    if (moved <= small * largest) break;
  }
  for (size_t j = 0; j < columns; ++j) x[j] = scale[j] > 0 ? x[j] / scale[j] : 0;
  return x;
}

}  // namespace lamina
