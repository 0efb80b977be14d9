// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "harness/cli/compare.h"

namespace lamina {

// What lamina compare does with --against-all-effects: the frame in which only what the scene calls for runs, against the one
// in which everything runs that can. Leaves the record and the report in options.out. Returns the exit status: 1 where the two
// pictures differ.
int run_against_all(const CompareOptions& options);

}  // namespace lamina
