// SPDX-License-Identifier: Apache-2.0
// Verdicts on the times of paired frames from several processes.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "harness/gate/limits.h"
#include "harness/gate/paired_frames.h"
#include "harness/record/gate_rows.h"

namespace lamina {

// Its backend, effect and variant.
using TimedCell = std::array<std::string, 3>;

struct TimeReport {
  std::vector<VerdictRow> rows;  // of frames (pass "") and of passes
  std::vector<SameArmRow> same_arms;
  size_t rounds = 0, comparisons = 0;
  std::set<TimedCell> undecided;  // what has an ambiguous row, and then the A/A arms that are not known to be the same
};
// All rows belong to one gate. A row's time before is the median over processes; its time after is that times the ratio, since
// absolute times wander more than the ratio. `family_error` as for judge_times(). Where an A/A arm reads as slower or faster,
// no time can be believed: every row that is not the same becomes ambiguous and says so.
TimeReport judge_pairs(const std::vector<PairsRow>& pairs, const LimitsFile& limits, double family_error);

// The ratio of a frame's time to that of the row's first frame, of one pass or of the whole frame. In the whole frame passes
// weigh by their times; a pass that only one frame has counts with its own time. Throws as estimate_ratio() does, and where
// either frame lacks the pass.
RatioEstimate estimate_of(const PairsRow& row, std::string_view frame, std::optional<size_t> pass = std::nullopt);

// The rounds that the rows hold, all together.
size_t rounds_in(const std::vector<PairsRow>& pairs);

// The greatest error of the ratios in this row that judge_pairs() would judge, over the margin.
double worst_error(const PairsRow& row, const LimitsFile& limits);

}  // namespace lamina
