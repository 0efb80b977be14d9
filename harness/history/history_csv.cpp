// SPDX-License-Identifier: Apache-2.0
// Trends as comma-separated values (Shafranovich, "Common Format and MIME Type for CSV Files", RFC 4180, 2005).
#include <fmt/format.h>

#include <array>

#include "harness/history/history_reports.h"
#include "reports/words.h"

namespace lamina {
namespace {

template <class Range>
std::string csv_line(const Range& fields) {
  std::string line;
  for (const auto& field : fields) line += (line.empty() ? "" : ",") + csv_field(field);
  return line + "\r\n";
}

constexpr std::array<const char*, 18> columns = {"scene",  "effect", "variant", "backend", "view",    "width",
                                                 "height", "params", "figure",  "unit",    "machine", "record",
                                                 "commit", "date",   "value",   "step",    "before",  "after"};

}  // namespace

std::string history_csv(const History& history) {
  const auto number = [](double value) { return fmt::format("{}", value); };
  std::string csv = csv_line(columns);
  for (const Trend& trend : history.trends)
    for (size_t i = 0; i < trend.points.size(); ++i) {
      const HistoryRecord& record = history.records[trend.points[i].record];
      const TrendStep* step = nullptr;
      for (const TrendStep& one : trend.steps)
        if (one.point == i) step = &one;
      const TrendCell& cell = trend.cell;
      csv += csv_line(std::array<std::string, columns.size()>{
          cell.scene, cell.effect, cell.variant, cell.backend, cell.view, number(static_cast<double>(cell.width)),
          number(static_cast<double>(cell.height)), cell.params, std::string(trend.figure->name),
          std::string(trend.figure->unit), trend.machine, record.name, commit_of(record), day_of(record),
          number(trend.points[i].value), step ? "1" : "0", step ? number(step->before) : "", step ? number(step->after) : ""});
    }
  return csv;
}

}  // namespace lamina
