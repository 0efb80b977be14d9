// SPDX-License-Identifier: Apache-2.0
// Which passes of a graph need not run, and whether those that do find what they read.
#pragma once

#include "harness/graph/graph.h"

namespace lamina {

// A pass whose targets are all shared and that another effect's pass has written already. Throws Error(bad_input) where the two
// declare such a target differently.
void leave_out_repeated(Graph& graph);

// A draw into what no later draw reads and the frame does not show.
void leave_out_unread(Graph& graph);

// Throws Error(bad_input) naming the pass that reads a target before anything wrote it. What a pass itself writes it may read
// from its first repetition on, where it finds the target cleared.
void check_written_before_read(const Graph& graph);

}  // namespace lamina
