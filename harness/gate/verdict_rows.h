// SPDX-License-Identifier: Apache-2.0
// Rows of verdicts on one variant on one backend while they are made.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/gate/limits.h"
#include "harness/record/gate_rows.h"

namespace lamina {

// A row that names its cell becomes that of a frame that takes longer than its bound.
inline void fail_frame_ms(VerdictRow& row, double ms, double bound) {
  row.what = "frame_ms", row.verdict = Verdict::failed, row.cause = Cause::beyond_bound, row.after = ms, row.limit = bound;
  row.details.clear(), row.counts_hold.reset();
}

struct VerdictSubject {
  const Limits& limits;
  VerdictRow blank;  // names the variant and backend
  std::vector<VerdictRow>& rows;

  VerdictRow& add(std::string_view what, Verdict verdict, Cause cause, std::string view = "",
                  std::vector<std::string> details = {}) const {
    VerdictRow& row = rows.emplace_back(blank);
    row.what = what, row.verdict = verdict, row.cause = cause;
    row.view = std::move(view), row.details = std::move(details);
    return row;
  }
};

}  // namespace lamina
