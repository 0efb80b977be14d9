// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/verdict.h"

#include <algorithm>

namespace lamina {

GateOutcome outcome_of(std::span<const VerdictRow> rows) {
  const auto any = [&](auto... verdicts) {
    return std::any_of(rows.begin(), rows.end(), [&](const VerdictRow& row) { return ((row.verdict == verdicts) || ...); });
  };
  if (any(Verdict::failed, Verdict::worse, Verdict::slower)) return {Verdict::failed, 1};
  if (any(Verdict::ambiguous) || !any(Verdict::same, Verdict::faster, Verdict::better)) return {Verdict::ambiguous, 3};
  return {any(Verdict::faster) ? Verdict::faster : Verdict::same, 0};
}

}  // namespace lamina
