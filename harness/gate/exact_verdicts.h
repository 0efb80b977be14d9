// SPDX-License-Identifier: Apache-2.0
// Verdicts on figures without noise: counts, pictures and errors of one cell before and after a change.
#pragma once

#include <optional>
#include <vector>

#include "harness/core/image.h"
#include "harness/gate/limits.h"
#include "harness/record/cell_rows.h"
#include "harness/record/gate_rows.h"

namespace lamina {

// The greatest difference between two pictures in r, g, b, linear light, and, where `alpha` counts, in alpha; one that is no
// number counts as none. Throws Error(failed) for pictures of two sizes.
double max_change(const Image& picture, const Image& before, bool alpha);

// One variant on one backend: the cells of all its views, in one order before and after; absent where there is none. `changes`
// is beside `after`, or empty where no pictures were compared.
struct CellPair {
  std::vector<std::optional<CellRow>> before, after;
  std::vector<std::optional<double>> changes;  // max_change()
  // One machine and driver drew both: then a hash that changed is a picture that changed, however little.
  bool hashes_tell = false;
};

// One row for each kind of figure that is the same in all views; one row for each view, pass and texture where it is not. A
// cell that was not there before must keep to the limits' bounds, and must show something finite.
std::vector<VerdictRow> judge_cells(const CellPair& pair, const Limits& limits);

}  // namespace lamina
