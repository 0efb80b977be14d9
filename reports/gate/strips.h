// SPDX-License-Identifier: Apache-2.0
// The strips behind a gate's times, by what was compared and by process, so that a sceptic can look.
#pragma once

#include <string>
#include <vector>

#include "harness/measure/ratio_estimate.h"
#include "harness/record/record.h"

namespace lamina {

struct GateStrips {
  std::string effect, variant, backend, view, pass;
  bool same_arm = false;                // A/A: the old tree against itself, else the new tree against the old
  const VerdictRow* verdict = nullptr;  // the record's line on it, which must outlive this; null where none is
  struct Process {
    size_t number = 0;  // 0, 1, ..., as in the record
    RatioEstimate estimate;
    std::vector<StripPair> strips;
  };
  std::vector<Process> processes;
};

// Comparisons in the order of their first pairs. A process whose strips give no ratio (too few of them, a time that is not
// positive) is left out.
std::vector<GateStrips> gate_strips(const Record& record);

// "light_map on vulkan, view front, pass composite", with "A/A " before it for a same arm.
std::string words_for_comparison(const GateStrips& strips);

}  // namespace lamina
