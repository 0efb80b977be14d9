// SPDX-License-Identifier: Apache-2.0
// A sweep's curves and answers as text.
#pragma once

#include "harness/sweep/curves.h"
#include "reports/reports.h"
#include "reports/tables/table.h"

namespace lamina {

// A table of the curves of one backend, effect and parameter: a row a point; for each variant but the baseline SSIM, FLIP and,
// where it was timed, the ratio. Figures that are not known are "-". `max_rows`: evenly spread where there are more points.
std::vector<Table> curve_tables(const std::vector<Curve>& curves, size_t max_rows);

std::string sweep_terminal(const std::vector<Curve>& curves);
// The record's answers, those about limits first, in as many lines as can be read; a last one says how many more are in
// `summary`.
std::string answers_terminal(const Record& record, const std::filesystem::path& summary);

}  // namespace lamina
