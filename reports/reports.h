// SPDX-License-Identifier: Apache-2.0
// Everything a person reads, made from a record alone: the same bytes for the same record.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/record/record.h"

namespace lamina {

// One line of every table: a variant of an effect on a backend, over all its views.
struct SummaryRow {
  std::string effect, variant, backend;
  bool baseline = false;
  size_t views = 0, failed_views = 0;
  std::string reason;                     // of the first failure
  std::optional<Interval> frame_ms;       // per view: the median over rounds of the mean over views of the frame's time
  std::optional<Interval> ratio;          // to the baseline, paired by round, over all views' times together
  double fetches_per_pixel = 0;           // over all views: fetches / covered pixels
  std::optional<ErrorFigures> mean, worst;  // over views, covered pixels; worst: each figure's own worst view
  std::string worst_view;                 // by FLIP
};
std::vector<SummaryRow> summarize(const Record& record);

// The terminal's table, `colour` with ANSI emphasis.
std::string terminal_table(const Record& record, bool colour);
std::string markdown_summary(const Record& record);
std::string cells_csv(const Record& record);
// One page that opens from disk, offline; pictures by relative path from the run's folder.
std::string html_report(const Record& record);

// Writes summary.md, cells.csv and index.html beside the record.
void write_reports(const std::filesystem::path& run_folder);

}  // namespace lamina
