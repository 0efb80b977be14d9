// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "harness/history/history_reports.h"
#include "harness/history/history_words.h"
#include "reports/html/html.h"

namespace lamina {
namespace {

constexpr double chart_wide = 240, chart_high = 40, margin = 4;

std::string chart(const Trend& trend, const History& history, const std::string& name) {
  const TrendFigure& figure = *trend.figure;
  const TrendAxis axis(trend);
  const auto x = [&](const Trend::Point& point) {
    return chart_wide * (static_cast<double>(point.record) + 0.5) / static_cast<double>(history.records.size());
  };
  std::string line, dots, steps;
  for (const Trend::Point& point : trend.points) {
    const double y = chart_high - margin - axis.height(point.value) * (chart_high - 2 * margin);
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x(point), y);
    dots +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"><title>{}: {}</title></circle>", x(point), y,
                    escaped_html(commit_of(history.records[point.record])), with_unit(words_for(point.value, figure), figure));
  }
  for (const TrendStep& step : trend.steps)
    steps += fmt::format("M{:.1f} 0V{}", (x(trend.points[step.point - 1]) + x(trend.points[step.point])) / 2, chart_high);
  return fmt::format(
      "<svg class=\"trend\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} over {} records, {} step{}\"><path "
      "class=\"step\" "
      "d=\"{}\"/><path class=\"line\" d=\"{}\"/>{}</svg>",
      chart_wide, chart_high, escaped_html(name), trend.points.size(), trend.steps.size(), trend.steps.size() == 1 ? "" : "s",
      steps, line, dots);
}

std::string table_of(const CellTrends& cell, const History& history, const HistoryNames& names) {
  const std::string name = names.of(cell.cell);
  Table table = {.columns = {words_column("figure"), words_column("over the records"), words_column("first"),
                             words_column("last"), words_column("change"), words_column("steps")},
                 .label = "History of " + name};
  for (const Trend* trend : cell.moving) {
    const TrendFigure& figure = *trend->figure;
    const double first = trend->points.front().value, last = trend->points.back().value;
    Row& row = table.rows.emplace_back(row_of({names.of(*trend), "", words_for(first, figure), words_for(last, figure),
                                               words_for_change(first, last, figure), std::to_string(trend->steps.size())}));
    row.cells[1].html = chart(*trend, history, names.of(*trend));
  }
  std::string html = fmt::format("<h3>{}</h3>\n", escaped_html(name));
  if (!table.rows.empty()) html += html_table(table) + "\n";
  if (!cell.still.empty())
    html += fmt::format("<p class=\"note\">Unchanged: {}.</p>\n", escaped_html(fmt::format("{}", fmt::join(cell.still, ", "))));
  return html;
}

}  // namespace

std::string html_history(const History& history) {
  std::string html = fmt::format("<section id=\"history\"><h2>Over commits</h2>\n<p>This is the {}.</p>\n",
                                 escaped_html(words_for_span(history)));
  const std::vector<StepWords> steps = words_for_steps(history);
  if (steps.empty()) html += "<p><strong>No steps: nothing changed for good.</strong></p>\n";
  std::string list;
  for (const StepWords& step : steps)
    list += fmt::format("<li>{} {}</li>\n", step.worse ? "<strong class=\"bad\">worse</strong>" : "<strong>better</strong>",
                        escaped_html(step.sentence));
  if (!list.empty()) html += "<ul>\n" + list + "</ul>\n";
  const HistoryNames names(history);
  std::vector<std::string> notes = history.notes;
  for (const std::string& machine : names.machines()) notes.push_back(machine);
  for (const std::string& note : notes) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(note));
  for (const CellTrends& cell : by_cell(history)) html += table_of(cell, history, names);
  return html + "</section>\n";
}

}  // namespace lamina
