// SPDX-License-Identifier: Apache-2.0
// For the error that a reader can bear, what to take: the frontier as a table, from the closest variant to the cheapest.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/words.h"

namespace lamina {
namespace {

const ErrorMetric& metric = error_metrics[0];  // SSIM, which people who read tables know

const std::optional<ErrorFigures>& errors_of(const CostAndErrors& figures, Reference reference) {
  return reference == Reference::baseline ? figures.to_baseline : figures.to_truth;
}

// Of the baseline's: a ratio of times, or of fetches.
std::string cost_words(const SummaryRow& row, const SummaryRow* baseline, bool timed) {
  if (row.baseline) return "1";
  if (timed) return row.ratio ? words_for_ratio(*row.ratio) : "-";
  if (!baseline || !row.fetches_per_pixel || !baseline->fetches_per_pixel || *baseline->fetches_per_pixel == 0) return "-";
  return fmt::format("{:.3f}", *row.fetches_per_pixel / *baseline->fetches_per_pixel);
}

// One backend's rows of one effect, behind those of the table.
void add_choices(Table& table, const std::vector<const SummaryRow*>& group, Reference reference, bool timed) {
  std::vector<CostAndErrors> figures;
  for (const SummaryRow* row : group) figures.push_back(figures_of(*row));
  const std::vector<Place> places = places_of(figures, timed ? Cost::time : Cost::fetches, metric, reference);
  std::vector<size_t> chosen;
  for (size_t i = 0; i < group.size(); ++i)
    if (places[i].standing == Standing::on_frontier) chosen.push_back(i);
  std::ranges::sort(chosen, std::greater(), [&](size_t i) { return errors_of(figures[i], reference)->ssim; });
  const auto baseline = std::ranges::find_if(group, [](const SummaryRow* row) { return row->baseline; });
  if (chosen.size() < 2) return;  // nothing to choose
  for (const size_t i : chosen) {
    const ErrorFigures& errors = *errors_of(figures[i], reference);
    std::vector<std::string> not_told;
    for (size_t other = 0; other < group.size(); ++other)
      if (places[other].standing == Standing::not_told_apart && places[other].by == i)
        not_told.push_back(group[other]->variant);
    Row row =
        row_of({fmt::format("{:.{}f}", errors.ssim, errors.ssim > 0.9995 && errors.ssim < 1 ? 6 : 4), group[i]->variant,
                cost_words(*group[i], baseline == group.end() ? nullptr : *baseline, timed), words_for_psnr(errors.psnr_db),
                fmt::format("{:.4f}", errors.flip), not_told.empty() ? "-" : fmt::format("{}", fmt::join(not_told, ", "))},
               group[i]->baseline ? Mark::baseline : Mark::none);
    row.group = row.group_words = group[i]->backend;
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

std::vector<Table> choices_tables(const std::vector<SummaryRow>& rows) {
  std::vector<Table> tables;
  std::vector<std::string> done;
  for (const SummaryRow& first : rows) {
    if (std::ranges::find(done, first.effect) != done.end()) continue;
    done.push_back(first.effect);
    const bool timed =
        std::ranges::any_of(rows, [&](const SummaryRow& row) { return row.effect == first.effect && row.frame_ms; });
    for (const Reference reference : {Reference::baseline, Reference::truth}) {
      const char* to = reference == Reference::baseline ? "baseline" : "truth";
      Table table;
      table.caption = fmt::format("{}: for the error to the {} that you can bear, take this", first.effect, to);
      table.columns = {number_column("SSIM down to"),
                       words_column("take"),
                       figures_column(timed ? "time, of the baseline's" : "fetches, of the baseline's"),
                       number_column("PSNR dB"),
                       number_column("FLIP"),
                       words_column("not told apart from it")};
      table.grouped_by = "backend";
      std::vector<std::string> backends;
      for (const SummaryRow& row : rows) {
        if (row.effect != first.effect || std::ranges::find(backends, row.backend) != backends.end()) continue;
        backends.push_back(row.backend);
        std::vector<const SummaryRow*> group;
        for (const SummaryRow& each : rows)
          if (each.effect == first.effect && each.backend == row.backend) group.push_back(&each);
        add_choices(table, group, reference, timed);
      }
      if (!table.rows.empty()) tables.push_back(std::move(table));
    }
  }
  return tables;
}

}  // namespace lamina
