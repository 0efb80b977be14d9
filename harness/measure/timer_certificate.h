// SPDX-License-Identifier: Apache-2.0
// Certifies a backend's timer: it times passes of known relative work with the same timer that measures variants.
// Software rasterizers and tile-based devices have reported the last tile's time, or another pass's, for a pass's.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// Bounds that a certificate holds to.
inline constexpr double linearity_tolerance = 0.05;
inline constexpr double additivity_tolerance = 0.05;

// The certificate of measured rounds. times_ms[round][k] is the time of the pass of multiple 1 << k; wall_ms[round] is the
// frame's wall time. Linearity, additivity and attribution are medians over rounds of ratios within a round, so a machine whose
// speed drifts from round to round is not taken for a bad timer. Throws Error(failed) where there are no rounds.
TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms);

// Measures (some seconds; up to twenty on a machine too busy to pass) and judges. `shaders` is the folder of the
// built-in shaders.
TimerRow certify_timer(Backend& backend, const std::filesystem::path& shaders);

}  // namespace lamina
