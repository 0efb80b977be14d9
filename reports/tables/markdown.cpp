// SPDX-License-Identifier: Apache-2.0
// Tables of GitHub Flavored Markdown Spec 0.29, section 4.10.
#include "reports/markdown.h"

#include <fmt/ranges.h>

#include "reports/tables/table.h"

namespace lamina {

std::vector<std::string> markdown_lines(const Table& table) {
  const bool grouped = !table.grouped_by.empty();
  const auto cell = [](const std::string& text) { return fmt::format(" {} |", escaped_markdown(text)); };
  std::string head = grouped ? "|" + cell(table.grouped_by) : "|", rule = grouped ? "|---|" : "|";
  for (const Column& column : table.columns) {
    head += cell(column.heading);
    rule += column.right ? "---:|" : "---|";
  }
  std::vector<std::string> lines = {head + "\n" + rule + "\n"};
  for (const Row& row : table.rows) {
    std::string line = grouped ? "|" + cell(row.group) : "|";
    for (const Cell& one : row.cells) line += cell(fmt::format("{}{}", one.text, fmt::join(one.items, ", ")));
    lines.push_back(line + "\n");
  }
  return lines;
}

std::string markdown_table(const Table& table, const char* before_caption) {
  std::string text = table.caption.empty() ? "" : fmt::format("{}{}\n\n", before_caption, escaped_markdown(table.caption));
  for (const std::string& line : markdown_lines(table)) text += line;
  return text;
}

}  // namespace lamina
