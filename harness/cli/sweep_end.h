// SPDX-License-Identifier: Apache-2.0
// How a sweep, or a join of its shards, ends.
#pragma once

#include "harness/record/record.h"

namespace lamina {

// Finds the answers of the record in `out`, appends them, writes the reports and prints curves and answers. Returns whether a
// cell failed or a timer could not be certified.
bool end_sweep(const std::filesystem::path& out, RecordWriter& record);

}  // namespace lamina
