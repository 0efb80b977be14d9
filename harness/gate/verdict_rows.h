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
  row.what = "frame_ms", row.verdict = Verdict::failed, row.after = ms, row.limit = bound;
  row.sentence =
      fmt::format("{} on {}: the frame takes {:.4g} ms, the gate file allows {:.4g}", row.variant, row.backend, ms, bound);
}

struct VerdictSubject {
  const Limits& limits;
  VerdictRow blank;  // names the variant and backend
  std::vector<VerdictRow>& rows;

  VerdictRow& add(std::string_view what, Verdict verdict, std::string sentence, std::string view = "") const {
    VerdictRow& row = rows.emplace_back(blank);
    row.what = what;
    row.verdict = verdict;
    row.sentence = std::move(sentence);
    row.view = std::move(view);
    return row;
  }

  // "light_map on vulkan, view front": how sentences begin.
  std::string name(const std::string& view = "") const {
    return fmt::format("{} on {}{}", blank.variant, blank.backend, view.empty() ? "" : ", view " + view);
  }
};

}  // namespace lamina
