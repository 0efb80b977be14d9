// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "harness/history/history_reports.h"
#include "reports/terminal.h"
#include "reports/words.h"

namespace lamina {
namespace {

using namespace terminal;

constexpr size_t most_bars = 48;
constexpr double least_span = 0.05;  // of a noisy figure's greatest value

std::string words_for(double value, const TrendFigure& figure) { return fmt::format("{:.{}f}", value, figure.digits); }

std::string with_unit(const std::string& words, const TrendFigure& figure) {
  return figure.unit.empty() ? words : fmt::format("{} {}", words, figure.unit);
}

// In percent where the figure has a natural zero, else as a difference.
std::string change(double before, double after, const TrendFigure& figure) {
  if (figure.lower_is_better && before > 0) return fmt::format("{:+.1f}%", 100 * (after / before - 1));
  return fmt::format("{:+.{}f}", after - before, figure.digits);
}

std::string chart(const Trend& trend, size_t records) {
  constexpr std::array<const char*, 8> bars = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  double least = INFINITY, greatest = -INFINITY;
  for (const Trend::Point& point : trend.points) {
    if (!std::isfinite(point.value)) continue;
    least = std::min(least, point.value);
    greatest = std::max(greatest, point.value);
  }
  const double span = std::max(greatest - least, trend.figure->noisy ? least_span * std::abs(greatest) : 0);
  const size_t first = records > most_bars ? records - most_bars : 0;
  std::vector<std::string> cells(records - first, " ");
  for (const auto& [record, value] : trend.points) {
    if (record < first) continue;
    const double height = value == INFINITY ? 1 : span > 0 ? (value - least) / span : 0;
    cells[record - first] = bars[static_cast<size_t>(std::lround(height * (bars.size() - 1)))];
  }
  return fmt::format("{}{}", first > 0 ? "…" : "", fmt::join(cells, ""));
}

std::string name_of(const TrendCell& cell, bool several_scenes) {
  const std::string scene = several_scenes ? fmt::format("{} {}x{}, ", cell.scene, cell.width, cell.height) : "";
  return one_line(fmt::format("{}{} on {}, view {}", scene, cell.variant, cell.backend, cell.view));
}

// "A", "B", ...: one letter a machine, in order of appearance; beyond Z numbers.
std::map<std::string, std::string> letters_of(const History& history) {
  std::map<std::string, std::string> letters;
  for (const Trend& trend : history.trends)
    if (!trend.machine.empty() && !letters.contains(trend.machine)) {
      const size_t index = letters.size();
      letters[trend.machine] = index < 26 ? std::string(1, static_cast<char>('A' + index)) : fmt::format("{}", index + 1);
    }
  return letters;
}

std::string name_of(const Trend& trend, const std::map<std::string, std::string>& letters) {
  std::string name = with_unit(std::string(trend.figure->name), *trend.figure);
  if (!trend.machine.empty() && letters.size() > 1) name += fmt::format(" on machine {}", letters.at(trend.machine));
  return name;
}

void add_steps(Lines& lines, const History& history, bool several, const std::map<std::string, std::string>& letters) {
  size_t count = 0;
  for (const Trend& trend : history.trends) {
    for (const TrendStep& step : trend.steps) {
      if (count++ == 0) lines.add("steps", bold);
      const TrendFigure& figure = *trend.figure;
      const HistoryRecord& record = history.records[trend.points[step.point].record];
      const std::string day = day_of(record);
      lines.add(one_line(fmt::format("  {}: {} {} -> {} ({}) at commit {}{} ({}){}", name_of(trend.cell, several),
                                     name_of(trend, letters), words_for(step.before, figure), words_for(step.after, figure),
                                     change(step.before, step.after, figure), commit_of(record), day.empty() ? "" : ", " + day,
                                     record.name, step.elsewhere ? "; the machine or driver changed here too" : "")),
                (step.after > step.before) == figure.lower_is_better ? red : green);
    }
  }
  if (count == 0) lines.add("no steps: nothing changed for good", bold);
}

bool moves(const Trend& trend) { return trend.figure->noisy || !trend.steps.empty(); }

void add_cell(Lines& lines, const std::vector<const Trend*>& trends, size_t records,
              const std::map<std::string, std::string>& letters) {
  std::vector<Cells> table;
  std::vector<std::string> still;
  for (const Trend* trend : trends) {
    const TrendFigure& figure = *trend->figure;
    const double first = trend->points.front().value, last = trend->points.back().value;
    if (!moves(*trend)) {
      still.push_back(fmt::format("{} {}", figure.name, with_unit(words_for(last, figure), figure)));
      continue;
    }
    table.push_back(
        {"  " + name_of(*trend, letters), chart(*trend, records), words_for(first, figure), "->", words_for(last, figure),
         change(first, last, figure),
         trend->steps.empty() ? "" : fmt::format("{} step{}", trend->steps.size(), trend->steps.size() == 1 ? "" : "s")});
  }
  const std::vector<size_t> widths = column_widths(table);
  for (const Cells& cells : table)
    lines.add(one_line(aligned(cells, widths, {false, false, true, false, true, true, false})),
              cells.back().empty() ? "" : yellow);
  if (!still.empty()) lines.add(fmt::format("  unchanged: {}", fmt::join(still, ", ")), dim);
}

}  // namespace

std::string history_table(const History& history, bool colour) {
  Lines lines(colour);
  const auto& records = history.records;
  const auto words_of = [](const HistoryRecord& record) {
    const std::string day = day_of(record);
    return fmt::format("{}{}", commit_of(record), day.empty() ? "" : fmt::format(" ({})", day));
  };
  lines.add(one_line(fmt::format("history of {} records, {} to {}", records.size(), words_of(records.front()),
                                 words_of(records.back()))),
            bold);
  for (const std::string& note : history.notes) lines.add("note: " + one_line(note), dim);
  const std::map<std::string, std::string> letters = letters_of(history);
  if (letters.size() > 1)
    for (const auto& [machine, letter] : letters) lines.add(one_line(fmt::format("machine {}: {}", letter, machine)), dim);
  const bool several = std::ranges::any_of(history.trends, [&](const Trend& trend) {
    const TrendCell &a = trend.cell, &b = history.trends.front().cell;
    return a.scene != b.scene || a.width != b.width || a.height != b.height;
  });
  lines.add("");
  add_steps(lines, history, several, letters);
  for (size_t begin = 0; begin < history.trends.size();) {
    const TrendCell& cell = history.trends[begin].cell;
    std::vector<const Trend*> trends;
    for (size_t i = begin; i < history.trends.size() && history.trends[i].cell == cell; ++i)
      trends.push_back(&history.trends[i]);
    lines.add("");
    lines.add(name_of(cell, several), bold);
    add_cell(lines, trends, records.size(), letters);
    begin += trends.size();
  }
  return lines.take();
}

}  // namespace lamina
