// SPDX-License-Identifier: Apache-2.0
#include "reports/terminal.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/words.h"

namespace lamina::terminal {
namespace {

// Columns that UTF-8 text takes: its code points. Wide and combining characters are not looked for.
size_t columns_of(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

const char* emphasis_of(Mark mark) {
  constexpr const char* all[] = {"", bold, green, yellow, red};
  return all[static_cast<size_t>(mark)];
}

}  // namespace

void Lines::add(const std::string& text, const char* emphasis) {
  const bool emphasized = colour_ && *emphasis;
  text_ += fmt::format("{}{}{}\n", emphasized ? emphasis : "", text, emphasized ? reset : "");
}

void Lines::add(const Table& table, std::string_view indent) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : table.columns) lines[0].push_back(one_line(column.heading));
  for (const Row& row : table.rows)
    for (lines.emplace_back(); const Cell& cell : row.cells) lines.back().push_back(one_line(cell.text));
  std::vector<size_t> widths;
  for (const Column& column : table.columns) widths.push_back(column.min_width);
  for (const auto& cells : lines)
    for (size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], columns_of(cells[i]));

  const auto aligned = [&](const std::vector<std::string>& cells) {
    std::string line(indent);
    for (size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - columns_of(cells[i]), ' ');
      line += (i == 0 ? "" : "  ") + (table.columns[i].right ? padding + cells[i] : cells[i] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  };
  if (!table.caption.empty()) add(one_line(table.caption), bold);
  if (std::ranges::any_of(lines[0], [](const std::string& heading) { return !heading.empty(); })) add(aligned(lines[0]), dim);
  for (size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    add(aligned(lines[i + 1]), emphasis_of(row.mark));
    if (!row.note.empty()) add(std::string(indent) + "  " + one_line(row.note), emphasis_of(row.note_mark));
  }
}

}  // namespace lamina::terminal

namespace lamina {

Row row_of(const std::vector<std::string>& cells, Mark mark) {
  return {.cells = {cells.begin(), cells.end()}, .mark = mark, .note = "", .group = "", .group_words = ""};
}

std::string terminal_table(const Table& table, bool colour) {
  terminal::Lines lines(colour);
  lines.add(table);
  return lines.take();
}

}  // namespace lamina
