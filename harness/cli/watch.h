// SPDX-License-Identifier: Apache-2.0
// lamina compare --watch: for a person who writes a shader.
#pragma once

#include "harness/cli/options.h"
#include "harness/measure/rounds.h"

namespace lamina {

struct WatchOptions : CellOptions {
  RoundOptions rounds;
  std::vector<std::string> views;  // by name; empty: the first
  bool timed = false;
};

// Draws every variant on the first backend of the options, writes OUT/watch.html, and does so again for what a changed shader,
// manifest or scene file touches, until Ctrl-C; then leaves the record and the report. Returns 0, or 1 where a cell has failed
// in the end. Throws Error for what is wrong before the first picture but for mistakes in shaders, which the page shows.
int run_watch(const WatchOptions& options);

}  // namespace lamina
