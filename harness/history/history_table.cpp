// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/history/history_reports.h"
#include "harness/history/history_words.h"
#include "reports/terminal.h"
#include "reports/words.h"

namespace lamina {
namespace {

using namespace terminal;

constexpr size_t max_bars = 48;

std::string chart(const Trend& trend, size_t records) {
  constexpr std::array<const char*, 8> bars = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const TrendAxis axis(trend);
  const size_t first = records > max_bars ? records - max_bars : 0;
  std::vector<std::string> cells(records - first, " ");
  for (const auto& [record, value] : trend.points) {
    if (record < first) continue;
    cells[record - first] = bars[static_cast<size_t>(std::lround(axis.height(value) * (bars.size() - 1)))];
  }
  return fmt::format("{}{}", first > 0 ? "…" : "", fmt::join(cells, ""));
}

void add_steps(Lines& lines, const History& history) {
  const std::vector<StepWords> steps = words_for_steps(history);
  lines.add(steps.empty() ? "no steps: nothing changed for good" : "steps", bold);
  for (const StepWords& step : steps) lines.add("  " + one_line(step.sentence), step.worse ? red : green);
}

void add_cell(Lines& lines, const CellTrends& cell, size_t records, const HistoryNames& names) {
  Table table = {.columns = std::vector<Column>(7)};
  for (const size_t figure : {2, 4, 5}) table.columns[figure].right = true;
  for (const Trend* trend : cell.moving) {
    const TrendFigure& figure = *trend->figure;
    const double first = trend->points.front().value, last = trend->points.back().value;
    const size_t steps = trend->steps.size();
    table.rows.push_back(row_of(
        {names.of(*trend), chart(*trend, records), words_for(first, figure), "->", words_for(last, figure),
         words_for_change(first, last, figure), steps == 0 ? "" : fmt::format("{} step{}", steps, steps == 1 ? "" : "s")},
        steps == 0 ? Mark::none : Mark::doubtful));
  }
  lines.add(table, "  ");
  if (!cell.still.empty()) lines.add(fmt::format("  unchanged: {}", fmt::join(cell.still, ", ")), dim);
}

}  // namespace

std::string history_table(const History& history, bool colour) {
  Lines lines(colour);
  lines.add(one_line(words_for_span(history)), bold);
  for (const std::string& note : history.notes) lines.add("note: " + one_line(note), dim);
  const HistoryNames names(history);
  for (const std::string& machine : names.machines()) lines.add(one_line(machine), dim);
  lines.add("");
  add_steps(lines, history);
  for (const CellTrends& cell : by_cell(history)) {
    lines.add("");
    lines.add(one_line(names.of(cell.cell)), bold);
    add_cell(lines, cell, history.records.size(), names);
  }
  return lines.take();
}

}  // namespace lamina
