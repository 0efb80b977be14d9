// SPDX-License-Identifier: Apache-2.0
// A history for a person and for other programs.
#pragma once

#include <string>

#include "harness/history/trend.h"

namespace lamina {

// For a terminal: the steps first, with commit and by how much, then a line a cell and figure that moves, with a small chart of
// a character a record (the last 48), and what never changed. Noisy figures' charts span at least 5% of their greatest value,
// so that noise looks like noise. `colour`: with ANSI emphasis, red for steps to the worse.
std::string history_table(const History& history, bool colour);
// A section of the page of several records, without a script: the steps, then a chart a cell and figure that moves, whose dots
// name their commit and value.
std::string html_history(const History& history);
// RFC 4180, CRLF line ends, one line a cell, figure and record: what it is, "value", and where a level begins "step" 1 with
// "before" and "after". PSNR of identical pictures is "inf".
std::string history_csv(const History& history);

}  // namespace lamina
