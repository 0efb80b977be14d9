// SPDX-License-Identifier: Apache-2.0
// Verdicts on a run against a stored record, which another day made and perhaps another machine.
#pragma once

#include <vector>

#include "harness/gate/limits.h"
#include "harness/gate/verdict.h"
#include "harness/record/record.h"

namespace lamina {

// Throws Error(bad_input, "gate", `file`, ...) for a record that is cut short, holds no cells, is of another scene, moment of
// it or size of frame, or has no cell in common with the run.
void check_comparable(const Record& stored, const Record& run, const std::filesystem::path& file);

// How the machine of a backend differs from that of the record, in words; "" where CPU, threads, device, driver and build are
// the same: only then are times themselves compared, and the hashes of pictures.
std::string difference_of_machines(const Record& stored, const Record& run, const std::string& backend);

// Counts, pictures and errors as judge_cells() has them; each variant's ratio to its baseline; on the same machine times too.
// Two intervals of samples that are not paired give the ratio's: from the low end of one over the high end of the other, each
// at a confidence that makes them hold together. The margins are max_ratio_drift and max_drift.
std::vector<VerdictRow> judge_stored(const Record& stored, const Record& run, const LimitsFile& limits, double family_error);

}  // namespace lamina
