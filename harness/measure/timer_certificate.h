// SPDX-License-Identifier: Apache-2.0
// Certifies a backend's timer: it times passes of known relative work with the same timer that measures variants.
// Software rasterizers and tile-based devices have reported the last tile's time, or another pass's, for a pass's.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// How many passes of 0x, 1x, 2x, 4x and 8x work a frame has. What disturbs a pass costs a short one a greater share of its time:
// the short ones run more often, so that each kind is told about as well as another.
inline constexpr std::array<int, 5> timer_passes = {1, 4, 2, 1, 1};

// Bounds that a certificate holds to. Of 3%: where the pass of 8x work is 5.1% too long beside the others, its share of all is 3%
// too great.
inline constexpr double linearity_tolerance = 0.03;
inline constexpr double additivity_tolerance = 0.05;

// The certificate of measured rounds. times_ms[round] are the times of all passes of 0x, of 1x, 2x, 4x and 8x work, as
// many as timer_passes says; wall_ms[round] is the frame's wall time. All figures are medians over rounds of ratios within a round, so a machine whose speed drifts from
// round to round is not taken for a bad timer. The pass without work gives the fixed cost of a pass. The certificate holds
// where the 95% intervals lie wholly within the tolerances, and fails where one lies wholly outside; between, the machine is
// too busy to tell, which more rounds may mend. Throws Error(failed) where there are no rounds.
TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms);

// Measures and judges: some seconds, on a machine too busy to tell until `max_s` have gone. `shaders` is the folder of the
// built-in shaders.
TimerRow certify_timer(Backend& backend, const std::filesystem::path& shaders, double max_s = 90);

}  // namespace lamina
