// SPDX-License-Identifier: Apache-2.0
// Rows of verdicts on one variant on one backend while they are made.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/gate/limits.h"
#include "harness/record/gate_rows.h"

namespace lamina {

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
