// SPDX-License-Identifier: Apache-2.0
#include "reports/terminal.h"

#include <fmt/format.h>

#include <algorithm>

namespace lamina::terminal {

void Lines::add(const std::string& text, const char* emphasis) {
  const bool emphasized = colour_ && *emphasis;
  text_ += fmt::format("{}{}{}\n", emphasized ? emphasis : "", text, emphasized ? reset : "");
}

size_t columns_of(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::vector<size_t> column_widths(const std::vector<Cells>& table) {
  std::vector<size_t> widths(table.empty() ? 0 : table.front().size());
  for (const Cells& cells : table)
    for (size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], columns_of(cells[i]));
  return widths;
}

std::string aligned(const Cells& cells, const std::vector<size_t>& widths, const std::vector<bool>& figures) {
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i) {
    const std::string padding(widths[i] - columns_of(cells[i]), ' ');
    line += (i == 0 ? "" : "  ") + (figures[i] ? padding + cells[i] : cells[i] + padding);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace lamina::terminal
