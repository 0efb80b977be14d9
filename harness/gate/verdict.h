// SPDX-License-Identifier: Apache-2.0
// What all of a gate's verdicts come to.
#pragma once

#include <span>
#include <vector>

#include "harness/gate/limits.h"
#include "harness/record/gate_rows.h"

namespace lamina {

// The gate's verdict, from all rows: failed where any row is slower, worse or failed; ambiguous where any row is, or where
// nothing was compared; faster where a time is faster; else same. `status` is the exit status of the command: 0, 1 or 3.
struct GateOutcome {
  Verdict verdict = Verdict::same;
  int status = 0;
};
GateOutcome outcome_of(std::span<const VerdictRow> rows);

// Counts decide, times confirm. Where no pass of a variant executes more of anything and its pictures hold, a time that may or
// may not be slower is open and no longer ambiguous, unless the limits say that times must decide; and a time that is slower
// says what counts leave to blame. The same holds for a timer without a certificate, where it holds for all variants on its
// backend. A variant decides by counts where fetches and operations were compared.
void let_counts_decide(std::vector<VerdictRow>& rows, const LimitsFile& limits);

}  // namespace lamina
