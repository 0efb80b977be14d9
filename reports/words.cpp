// SPDX-License-Identifier: Apache-2.0
// Figures as text.
#include "reports/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/quality/judged_picture.h"

namespace lamina {
namespace {

constexpr double visible_alpha = 0.5 / 255;  // half a step of 8 bits

const char* mark_of(const Interval& interval) { return interval.coverage < report_confidence ? "*" : ""; }

std::string mean_and_worst(double mean, double worst, int digits) {
  return fmt::format("{:.{}f} ({:.{}f})", mean, digits, worst, digits);
}

std::vector<Column> summary_columns(bool truth) {
  std::vector<Column> columns = {words_column("variant"), words_column("backend")};
  for (const char* figure : {"frame ms [95%]", "ratio [95%]", "fetches/px", "PSNR dB", "SSIM", "FLIP"})
    columns.push_back(figures_column(figure));
  if (truth)
    for (const char* figure : {"PSNR dB to truth", "SSIM to truth", "FLIP to truth", "RMSE to truth"})
      columns.push_back(figures_column(figure));
  columns.push_back(words_column("worst view", "name"));
  return columns;
}

std::vector<std::string> summary_cells(const SummaryRow& row, bool truth) {
  const bool failed = row.failed_views == row.views;
  const std::string unknown = failed ? words_for_failure(row) : "-";
  const auto psnr = [](const ErrorFigures& mean, const ErrorFigures& worst) {
    return fmt::format("{} ({})", words_for_psnr(mean.psnr_db), words_for_psnr(worst.psnr_db));
  };
  std::vector<std::string> cells = {row.variant, row.backend,
                                    row.frame_ms ? words_for_ms(*row.frame_ms)
                                    : failed     ? words_for_failure(row)
                                                 : "not timed",
                                    row.baseline ? "baseline"
                                    : row.ratio  ? words_for_ratio(*row.ratio)
                                                 : unknown,
                                    row.fetches_per_pixel ? fmt::format("{:.1f}", *row.fetches_per_pixel) : unknown};
  if (row.mean && row.worst)
    cells.insert(cells.end(), {psnr(*row.mean, *row.worst), mean_and_worst(row.mean->ssim, row.worst->ssim, 4),
                               mean_and_worst(row.mean->flip, row.worst->flip, 4)});
  else
    cells.insert(cells.end(), 3, row.baseline ? "" : unknown);
  if (truth && row.mean_to_truth && row.worst_to_truth)
    cells.insert(
        cells.end(),
        {psnr(*row.mean_to_truth, *row.worst_to_truth), mean_and_worst(row.mean_to_truth->ssim, row.worst_to_truth->ssim, 4),
         mean_and_worst(row.mean_to_truth->flip, row.worst_to_truth->flip, 4),
         fmt::format("{:.3g} ({:.3g})", row.mean_to_truth->rmse_linear, row.worst_to_truth->rmse_linear)});
  else if (truth)
    cells.insert(cells.end(), 4, unknown);
  cells.push_back(row.mean ? row.worst_view : row.baseline ? "" : unknown);
  return cells;
}

bool has_truth(const std::vector<SummaryRow>& rows, const std::string& effect) {
  return std::ranges::any_of(rows, [&](const SummaryRow& row) { return row.effect == effect && row.mean_to_truth; });
}

}  // namespace

std::string words_for_failure(const SummaryRow& row) { return row.reason.starts_with(no_picture) ? "not a picture" : "failed"; }

Interval interval_or_range(std::vector<double> samples) {
  if (samples.size() >= min_rounds_for_95) return median_interval(samples);
  // No order statistics reach 95%; the range covers the median with 1 - 2 / 2^n.
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  return {.median = median(samples),
          .low = *low,
          .high = *high,
          .rounds = samples.size(),
          .coverage = 1 - std::exp2(1 - static_cast<double>(samples.size()))};
}

std::string words_for_ms(double ms) { return fmt::format("{:.{}f}", ms, ms >= 100 ? 1 : ms >= 10 ? 2 : 3); }

std::string words_for_ms(const Interval& ms) {
  return fmt::format("{} [{}, {}]{}", words_for_ms(ms.median), words_for_ms(ms.low), words_for_ms(ms.high), mark_of(ms));
}

std::string words_for_ratio(const Interval& ratio) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]{}", ratio.median, ratio.low, ratio.high, mark_of(ratio));
}

std::string words_for_psnr(double psnr_db) { return fmt::format("{:.1f}", psnr_db); }

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return line;
}

std::vector<Table> summary_tables(const std::vector<SummaryRow>& rows, bool truth) {
  std::vector<Table> tables;
  bool with_truth = false;
  for (const SummaryRow& row : rows) {
    if (tables.empty() || tables.back().caption != row.effect) {
      with_truth = truth && has_truth(rows, row.effect);
      tables.push_back({.caption = row.effect, .columns = summary_columns(with_truth), .html_class = "wide"});
    }
    Row& added =
        tables.back().rows.emplace_back(row_of(summary_cells(row, with_truth), row.baseline ? Mark::baseline : Mark::none));
    added.note = trouble_of(row);
  }
  return tables;
}

std::string trouble_of(const SummaryRow& row) {
  std::string words;
  if (row.failed_views > 0) words = fmt::format("failed in {} of {} views: {}", row.failed_views, row.views, row.reason);
  if (!row.beyond_limit.empty()) words += fmt::format("{}not recommended: {}", words.empty() ? "" : "; ", row.beyond_limit);
  if (row.max_alpha > visible_alpha)
    words += fmt::format("{}alpha differs from the baseline's by up to {:.3g}", words.empty() ? "" : "; ", row.max_alpha);
  if (row.nonfinite_pixels > 0)
    words += fmt::format("{}{} pixels are not finite, and no error figure is made of such a picture", words.empty() ? "" : "; ",
                         row.nonfinite_pixels);
  return words;
}

std::vector<std::string> summary_notes(const std::vector<SummaryRow>& rows) {
  std::vector<std::string> notes;
  if (rows.empty()) return notes;
  if (std::ranges::any_of(rows, [](const SummaryRow& row) { return row.frame_ms.has_value(); }))
    notes.push_back(
        "Frame: the median over rounds of the mean over views, without what is done once. Ratio: to the baseline's time, "
        "paired by round; under 1 is faster.");
  notes.push_back(
      "PSNR, SSIM and FLIP: mean over views (worst view), against the baseline, over the pixels that the effect covers, on "
      "8-bit sRGB. "
      "Worst view: by FLIP.");
  if (std::ranges::any_of(rows, [](const SummaryRow& row) { return row.mean_to_truth.has_value(); }))
    notes.push_back(
        "To truth: the same against the truth, an offline answer that no frame budget allows; RMSE is in linear light.");
  const auto short_of_rounds = [](const std::optional<Interval>& i) { return i && i->coverage < report_confidence; };
  if (std::any_of(rows.begin(), rows.end(),
                  [&](const SummaryRow& r) { return short_of_rounds(r.frame_ms) || short_of_rounds(r.ratio); }))
    notes.push_back(fmt::format("* fewer than {} rounds: the range of the samples, not a 95% interval.", min_rounds_for_95));
  return notes;
}

}  // namespace lamina
