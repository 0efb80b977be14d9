// SPDX-License-Identifier: Apache-2.0
// The frame in which only what a scene calls for runs, beside the one in which everything runs that can: pictures, counts,
// memory, and times in interleaved rounds.
#pragma once

#include <vector>

#include "harness/cli/cell.h"
#include "harness/cli/progress.h"
#include "harness/cli/scene_on_device.h"
#include "harness/measure/rounds.h"
#include "harness/record/saving_row.h"

namespace lamina {

// One row a view. `rounds`: absent where nothing is to be timed. What throws Error(failed) becomes every row's failure; Error
// of another kind goes through.
std::vector<SavingRow> saving_rows(Backend& backend, const Library& library, const Scene& scene, const Plan& plan,
                                   ShaderCache& shaders, const CellOptions& options, const std::optional<RoundOptions>& rounds,
                                   const Tell& tell);

}  // namespace lamina
