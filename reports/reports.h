// SPDX-License-Identifier: Apache-2.0
// Everything a person reads, made from a record alone: the same bytes for the same record.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/record/record.h"

namespace lamina {

// One line of every table: a variant of an effect on a backend, over all its views (each of them once a size and parameter set,
// where the record holds several). Failed cells count in failed_views and nowhere else. Times are absent where the backend's
// timer certificate is missing or failed. With fewer rounds than min_rounds_for_95 an interval is the range of the samples, and
// its coverage says so; where views have different numbers of rounds, the first rounds that all have are paired.
struct SummaryRow {
  std::string effect, variant, backend;
  bool baseline = false;
  size_t views = 0, failed_views = 0;
  double max_alpha = 0;              // the greatest over all views that have one
  uint64_t nonfinite_pixels = 0;     // over all views; a view with any has no error figures, nor has one whose baseline has
  std::string reason;                // of the first failure
  std::optional<Interval> frame_ms;  // per view: the median over rounds of the mean over views of the frame's time
  std::vector<double> rounds_ms;     // that mean of each round
  std::optional<Interval> ratio;  // to the baseline, paired by round, over all views' times together; both must have the view
  std::optional<double> fetches_per_pixel;  // over all views: fetches / covered pixels; absent where some view's are not known
  // Over views, covered pixels. Mean PSNR is that of the mean squared error, so that one identical view does not make it
  // infinite; the others are plain means. Worst: each figure's own worst view.
  std::optional<ErrorFigures> mean, worst;
  std::string worst_view;                                     // by FLIP
  std::optional<ErrorFigures> mean_to_truth, worst_to_truth;  // the same against the truth, over the views that have one
  std::string beyond_limit;  // "SSIM 0.3004, limit 0.7": the first of the run's limits that the mean does not keep; "" where it
                             // keeps all
};
// By effect and backend in order of appearance, each group's baseline first.
std::vector<SummaryRow> summarize(const Record& record);

// The terminal's table, `colour` with ANSI emphasis. Strings of the record lose their control characters.
std::string terminal_table(const Record& record, bool colour);
// The same as Markdown (GitHub's tables), with the passes, the plan and what was run.
std::string markdown_summary(const Record& record);
// RFC 4180, CRLF line ends, one line a cell under a header: the cell's scalar fields, named by their path in the record. What
// is not known is empty; PSNR of identical pictures is "inf". Times of a backend without a good timer certificate are empty.
std::string cells_csv(const Record& record);

// Where the page finds a picture that a record names by its path.
using PictureUrl = std::function<std::string(const std::string& path)>;
// One page of one or more records, which opens from disk, offline; without `url`, pictures are at their paths beside it.
// `settings.difference_gain` of a run line is what its difference pictures were multiplied by.
// `history`: a section about all records together, as HTML.
std::string html_report(const std::vector<Record>& records, const PictureUrl& url = nullptr, const std::string& history = "");

struct ReportOptions {
  bool single_file = false;   // pictures inside the page
  std::filesystem::path out;  // folder to write to; empty: the run's own, which must then be the only one
  std::string history;        // as for html_report()
};
// Writes index.html, summary.md, cells.csv, and for a gate's record what write_gate_reports() does, of the runs whose
// record.jsonl these folders hold, in their order. Into a folder of its own go copies of the pictures too, of several runs each
// into images/ of a folder a, b, ... The pixels of each picture beside the page are written again as a script, IMAGE.js, since
// browsers let no page read those of a file. Returns the page's path. Throws as read_record(), read_file() and
// write_file_atomically() do.
std::filesystem::path write_reports(const std::vector<std::filesystem::path>& run_folders, const ReportOptions& options);
// The same of one run, beside its record.
std::filesystem::path write_reports(const std::filesystem::path& run_folder);

}  // namespace lamina
