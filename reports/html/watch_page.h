// SPDX-License-Identifier: Apache-2.0
// The page of `lamina compare --watch`: the pictures and figures of every variant as they are now, and what is wrong.
#pragma once

#include <string>
#include <vector>

#include "harness/record/cell_rows.h"

namespace lamina {

struct WatchedVariant {
  std::string name, title;
  std::vector<CellRow> cells;  // the last good ones, a view each; empty: there was none
  std::string failure;         // why there is no newer one; the compiler's words
  bool is_new = false;         // made by the last change
};

struct WatchState {
  size_t generation = 0;                 // grows with every change
  std::string what;                      // "heart on vulkan (llvmpipe ...), 512x512"
  std::string changed;                   // the files of the last change; "" at first
  std::string failure;                   // of all: a manifest or scene that cannot be read
  double took_s = 0;                     // from the change to this page
  std::vector<WatchedVariant> variants;  // the baseline of each effect first
};

// Pictures are at their paths beside the page. The page loads watch.js (below) again and again, and itself again where that
// tells of another generation; so it needs no server.
std::string watch_page(const WatchState& state);
std::string watch_script(const WatchState& state);

}  // namespace lamina
