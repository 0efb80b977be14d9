// SPDX-License-Identifier: Apache-2.0
#include "reports/sweep/sweep_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/words.h"

namespace lamina {
namespace {

std::string figure(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

bool is_timed(const Curve& curve) {
  const std::vector<double>& ratios = curve.y.at("ratio");
  return std::any_of(ratios.begin(), ratios.end(), [](double value) { return !std::isnan(value); });
}

Table table_of(std::span<const Curve> group, size_t max_rows) {
  const Curve& first = group.front();
  constexpr size_t min_width = 8;  // so that the tables of a sweep look alike
  Table table;
  table.caption = fmt::format("{} on {}, over {}{}", first.effect, first.backend, first.parameter,
                              first.unit.empty() ? "" : " in " + first.unit);
  for (const Held& held : first.held)
    table.caption += fmt::format(", {} {:.6g}{}", held.path, held.value, held.unit.empty() ? "" : " " + held.unit);
  const auto add_column = [&](const std::string& heading) {
    table.columns.push_back({heading, true, "num", false, min_width});
  };
  add_column(first.parameter.substr(first.parameter.rfind('.') + 1));
  struct Figure {
    const Curve* curve;
    const char *metric, *format;
  };
  std::vector<Figure> figures;
  for (const Curve& curve : group) {
    if (curve.baseline) continue;
    const auto add = [&](const char* metric, const char* name, const char* format) {
      figures.push_back({&curve, metric, format});
      add_column(curve.variant + " " + name);
    };
    add("ssim", "SSIM", "{:.4f}"), add("flip", "FLIP", "{:.4f}");
    if (is_timed(curve)) add("ratio", "ratio", "{:.3f}");
  }
  const size_t count = first.x.size(), shown = std::min(count, max_rows);
  for (size_t row = 0; row < shown; ++row) {
    const size_t i = shown < 2 ? 0 : (row * (count - 1) + (shown - 1) / 2) / (shown - 1);
    std::vector<std::string> cells = {fmt::format("{:.6g}", first.x[i])};
    for (const auto& [curve, metric, format] : figures) {
      const auto at = std::lower_bound(curve->x.begin(), curve->x.end(), first.x[i]);
      const bool there = at != curve->x.end() && *at == first.x[i];
      cells.push_back(there ? figure(curve->y.at(metric)[static_cast<size_t>(at - curve->x.begin())], format) : "-");
    }
    table.rows.push_back(row_of(cells));
  }
  if (shown < count) table.caption += fmt::format(" ({} of {} points)", shown, count);
  return table;
}

}  // namespace

std::vector<Table> curve_tables(const std::vector<Curve>& curves, size_t max_rows) {
  std::vector<Table> tables;
  for (size_t begin = 0, end = 0; begin < curves.size(); begin = end) {
    while (end < curves.size() && in_one_group(curves[begin], curves[end])) ++end;
    tables.push_back(table_of(std::span(curves).subspan(begin, end - begin), max_rows));
  }
  return tables;
}

std::string sweep_terminal(const std::vector<Curve>& curves) {
  constexpr size_t rows_of_a_screen = 17, max_tables = 8;
  std::string text;
  const std::vector<Table> tables = curve_tables(curves, rows_of_a_screen);
  for (size_t i = 0; i < std::min(tables.size(), max_tables); ++i) text += "\n" + terminal_table(tables[i], false);
  if (tables.size() > max_tables) text += fmt::format("\n{} more tables are in summary.md\n", tables.size() - max_tables);
  return text;
}

std::string answers_terminal(const Record& record, const std::filesystem::path& summary) {
  constexpr size_t max_lines = 40;
  std::vector<Headline> all = crossover_headlines(record, Crossovers::about_limits);
  for (const Headline& answer : crossover_headlines(record, Crossovers::of_pairs)) all.push_back(answer);
  const size_t shown = all.size() <= max_lines ? all.size() : max_lines - 1;
  std::string text;
  for (size_t i = 0; i < shown; ++i)
    text += fmt::format("{}{}{}\n", one_line(all[i].variant), all[i].variant.empty() ? "" : ": ", one_line(all[i].words));
  if (shown < all.size()) text += fmt::format("{} more answers are in {}\n", all.size() - shown, summary.string());
  return text;
}

}  // namespace lamina
