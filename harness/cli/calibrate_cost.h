// SPDX-License-Identifier: Apache-2.0
// The cost model of a device, where lamina calibrate has kept it.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "harness/cost/cost_model.h"

namespace lamina {

// None where there is none, or it cannot be read.
std::optional<CostModel> kept_cost_model(const std::filesystem::path& cache, const std::string& backend,
                                         const std::string& device);
void keep_cost_model(const std::filesystem::path& cache, const CostModel& model);

// A note on each timed cell whose frame takes less than half or more than twice what its counts predict.
void note_times_that_counts_do_not_tell(const CostModel& model, std::span<CellRow> rows);

}  // namespace lamina
