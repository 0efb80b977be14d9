// SPDX-License-Identifier: Apache-2.0
// Leaves out passes that need not run, and checks that the others find what they read.
#pragma once

#include "harness/graph/graph.h"

namespace lamina {

// Leaves out a pass whose targets are all shared and already written by another effect's pass. Throws Error(bad_input) where
// the two declare such a target differently.
void leave_out_repeated(Graph& graph);

// Leaves out draws into targets that no later draw reads and that are not the frame.
void leave_out_unread(Graph& graph);

// Throws Error(bad_input) naming the pass that reads a target before anything wrote it. What a pass itself writes it may read
// from its first repetition on, where it finds the target cleared.
void check_written_before_read(const Graph& graph);

}  // namespace lamina
