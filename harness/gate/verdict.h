// SPDX-License-Identifier: Apache-2.0
// What all of a gate's verdicts come to.
#pragma once

#include <span>

#include "harness/record/gate_rows.h"

namespace lamina {

// The gate's verdict, from all rows: failed where any row is slower, worse or failed; ambiguous where any row is, or where
// nothing was compared; faster where a time is faster; else same. `status` is the exit status of the command: 0, 1 or 3.
struct GateOutcome {
  Verdict verdict = Verdict::same;
  int status = 0;
};
GateOutcome outcome_of(std::span<const VerdictRow> rows);

}  // namespace lamina
