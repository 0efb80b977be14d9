// SPDX-License-Identifier: Apache-2.0
#include "harness/history/history_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lamina {

std::string words_for(double value, const TrendFigure& figure) { return fmt::format("{:.{}f}", value, figure.digits); }

std::string with_unit(const std::string& words, const TrendFigure& figure) {
  return figure.unit.empty() ? words : fmt::format("{} {}", words, figure.unit);
}

std::string words_for_change(double before, double after, const TrendFigure& figure) {
  if (figure.lower_is_better && before > 0) return fmt::format("{:+.1f}%", 100 * (after / before - 1));
  return fmt::format("{:+.{}f}", after - before, figure.digits);
}

std::string words_for_span(const History& history) {
  const auto words_of = [](const HistoryRecord& record) {
    const std::string day = day_of(record);
    return fmt::format("{}{}", commit_of(record), day.empty() ? "" : fmt::format(" ({})", day));
  };
  return fmt::format("history of {} records, {} to {}", history.records.size(), words_of(history.records.front()),
                     words_of(history.records.back()));
}

HistoryNames::HistoryNames(const History& history) {
  for (const Trend& trend : history.trends) {
    const TrendCell &a = trend.cell, &b = history.trends.front().cell;
    several_scenes_ = several_scenes_ || a.scene != b.scene || a.width != b.width || a.height != b.height;
    if (trend.machine.empty() || letters_.contains(trend.machine)) continue;
    const size_t index = letters_.size();
    letters_[trend.machine] = index < 26 ? std::string(1, static_cast<char>('A' + index)) : fmt::format("{}", index + 1);
  }
}

std::string HistoryNames::of(const TrendCell& cell) const {
  const std::string scene = several_scenes_ ? fmt::format("{} {}x{}, ", cell.scene, cell.width, cell.height) : "";
  return fmt::format("{}{} on {}, view {}", scene, cell.variant, cell.backend, cell.view);
}

std::string HistoryNames::of(const Trend& trend) const {
  std::string name = with_unit(std::string(trend.figure->name), *trend.figure);
  if (!trend.machine.empty() && letters_.size() > 1) name += fmt::format(" on machine {}", letters_.at(trend.machine));
  return name;
}

std::vector<std::string> HistoryNames::machines() const {
  std::vector<std::string> lines;
  if (letters_.size() > 1)
    for (const auto& [machine, letter] : letters_) lines.push_back(fmt::format("machine {}: {}", letter, machine));
  std::ranges::sort(lines);
  return lines;
}

std::vector<StepWords> words_for_steps(const History& history) {
  const HistoryNames names(history);
  std::vector<StepWords> all;
  for (const Trend& trend : history.trends)
    for (const TrendStep& step : trend.steps) {
      const TrendFigure& figure = *trend.figure;
      const HistoryRecord& record = history.records[trend.points[step.point].record];
      const std::string day = day_of(record);
      all.push_back(
          {fmt::format("{}: {} {} -> {} ({}) at commit {}{} ({}){}", names.of(trend.cell), names.of(trend),
                       words_for(step.before, figure), words_for(step.after, figure),
                       words_for_change(step.before, step.after, figure), commit_of(record), day.empty() ? "" : ", " + day,
                       record.name, step.elsewhere ? "; the machine or driver changed here too" : ""),
           (step.after > step.before) == figure.lower_is_better});
    }
  return all;
}

TrendAxis::TrendAxis(const Trend& trend) {
  constexpr double min_span = 0.05;
  least_ = INFINITY;
  double greatest = -INFINITY;
  for (const Trend::Point& point : trend.points) {
    if (!std::isfinite(point.value)) continue;
    least_ = std::min(least_, point.value);
    greatest = std::max(greatest, point.value);
  }
  span_ = std::max(greatest - least_, trend.figure->noisy ? min_span * std::abs(greatest) : 0);
}

double TrendAxis::height(double value) const { return value == INFINITY ? 1 : span_ > 0 ? (value - least_) / span_ : 0; }

std::vector<CellTrends> by_cell(const History& history) {
  std::vector<CellTrends> cells;
  for (const Trend& trend : history.trends) {
    if (cells.empty() || cells.back().cell != trend.cell) cells.push_back({trend.cell, {}, {}});
    const TrendFigure& figure = *trend.figure;
    if (figure.noisy || !trend.steps.empty())
      cells.back().moving.push_back(&trend);
    else
      cells.back().still.push_back(
          fmt::format("{} {}", figure.name, with_unit(words_for(trend.points.back().value, figure), figure)));
  }
  return cells;
}

}  // namespace lamina
