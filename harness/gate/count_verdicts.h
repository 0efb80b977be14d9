// SPDX-License-Identifier: Apache-2.0
// Verdicts on what a cell executes before and after a change: invocations, fetches and operations of each pass. Counts have no
// noise, so one more is more.
#pragma once

#include <set>
#include <string>

#include "harness/gate/verdict_rows.h"
#include "harness/record/cell_rows.h"

namespace lamina {

// Adds a row for each count of a pass that is not as before. More is worse, beyond what the limits allow. Of operations, a pass
// has one row: worse where some class has more and none has fewer. Where some have more and others fewer, counts cannot say
// which costs more: the row is not compared, and times decide. A record without operations is not compared either. `changed`
// takes what the rows are about.
void judge_counts(const VerdictSubject& subject, const CellRow& before, const CellRow& after, std::set<std::string>& changed);

// Whether the cell's passes say which operations they executed; a record of before they were counted does not.
bool counts_operations(const CellRow& cell);

// Adds a row for each bound of the gate file that the cell exceeds: fetches, operations and bytes of targets of a frame.
void judge_work_bounds(const VerdictSubject& subject, const CellRow& cell);

}  // namespace lamina
