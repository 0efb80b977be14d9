// SPDX-License-Identifier: Apache-2.0
// Verdicts on a run against a stored record, which was made on another day and perhaps on another machine.
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

// Judges counts, pictures and errors as judge_cells() does, each variant's ratio to its baseline, and on the same machine times
// too. The samples are not paired, so a ratio's interval runs from the low end of one interval over the high end of the other
// to the reverse, each at a confidence that makes both hold together. The margins are max_ratio_drift and max_drift.
std::vector<VerdictRow> judge_stored(const Record& stored, const Record& run, const LimitsFile& limits, double family_error);

}  // namespace lamina
