// SPDX-License-Identifier: Apache-2.0
// The table that a run ends with, for a terminal of some 130 columns.
#include <fmt/format.h>

#include <algorithm>

#include "reports/words.h"

namespace lamina {
namespace {

// ECMA-48 "select graphic rendition".
constexpr const char *bold = "\x1b[1m", *dim = "\x1b[2m", *red = "\x1b[31m", *yellow = "\x1b[33m", *reset = "\x1b[0m";

// Characters that take a column: every byte but UTF-8's continuation bytes.
size_t columns_of(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

class Lines {
 public:
  explicit Lines(bool colour) : colour_(colour) {}
  void add(const std::string& text, const char* emphasis = "") {
    const bool emphasized = colour_ && *emphasis;
    text_ += fmt::format("{}{}{}\n", emphasized ? emphasis : "", text, emphasized ? reset : "");
  }
  std::string take() { return std::move(text_); }

 private:
  bool colour_;
  std::string text_;
};

using Cells = std::vector<std::string>;

// Names to the left, figures to the right.
std::string aligned(const Cells& cells, const std::vector<size_t>& widths) {
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i) {
    const std::string padding(widths[i] - columns_of(cells[i]), ' ');
    const bool name = i < 2 || i + 1 == cells.size();
    line += (i == 0 ? "" : "  ") + (name ? cells[i] + padding : padding + cells[i]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

void add_table(Lines& lines, const std::vector<const SummaryRow*>& rows) {
  std::vector<Cells> table = {summary_columns(false)};  // the columns against the truth are too many for a terminal
  for (const SummaryRow* row : rows) {
    table.push_back(summary_cells(*row, false));
    for (std::string& cell : table.back()) cell = one_line(cell);
  }
  std::vector<size_t> widths(table[0].size());
  for (const Cells& cells : table)
    for (size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], columns_of(cells[i]));
  lines.add(aligned(table[0], widths), dim);
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::string trouble = trouble_of(*rows[i]);
    lines.add(aligned(table[i + 1], widths), !trouble.empty() ? red : rows[i]->baseline ? bold : "");
    if (!trouble.empty()) lines.add("  " + one_line(trouble), red);
  }
}

}  // namespace

std::string terminal_table(const Record& record, bool colour) {
  Lines lines(colour);
  lines.add(one_line(title_of(record)), bold);
  const std::vector<SummaryRow> rows = summarize(record);
  for (size_t begin = 0; begin < rows.size();) {
    std::vector<const SummaryRow*> of_effect;
    for (size_t i = begin; i < rows.size() && rows[i].effect == rows[begin].effect; ++i) of_effect.push_back(&rows[i]);
    lines.add("");
    lines.add(one_line(rows[begin].effect), bold);
    add_table(lines, of_effect);
    begin += of_effect.size();
  }
  lines.add("");
  for (const std::string& note : summary_notes(rows)) lines.add(note, dim);
  for (const Certificate& certificate : certificates(record))
    if (certificate.ok) lines.add("timer: " + one_line(certificate.words), dim);
  for (const std::string& warning : warnings_of(record)) lines.add("warning: " + one_line(warning), yellow);
  return lines.take();
}

}  // namespace lamina
