// SPDX-License-Identifier: Apache-2.0
// Certifies a backend's timer: it times passes of known relative work with the same timer that measures variants.
// Software rasterizers and tile-based devices have reported the last tile's time, or another pass's, for a pass's.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// Bounds that a certificate holds to. Of 3%: where the pass of 8x work is 5.8% too long beside the others, each of these is 3%
// too short beside all.
inline constexpr double linearity_tolerance = 0.03;
inline constexpr double additivity_tolerance = 0.05;

// The certificate of measured rounds. times_ms[round] are the times of the passes of 0x, 1x, 2x, 4x and 8x work; wall_ms[round]
// is the frame's wall time. All figures are medians over rounds of ratios within a round, so a machine whose speed drifts from
// round to round is not taken for a bad timer. The pass without work gives the fixed cost of a pass. The certificate holds
// where the 95% intervals lie wholly within the tolerances, and fails where one lies wholly outside; between, the machine is
// too busy to tell, which more rounds may mend. Throws Error(failed) where there are no rounds.
TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms);

// Measures and judges: some seconds, on a machine too busy to tell until `max_s` have gone. `shaders` is the folder of the
// built-in shaders.
TimerRow certify_timer(Backend& backend, const std::filesystem::path& shaders, double max_s = 90);

}  // namespace lamina
