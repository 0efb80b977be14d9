// SPDX-License-Identifier: Apache-2.0
// The table that a run ends with, for a terminal of some 130 columns.
#include "reports/terminal.h"
#include "reports/words.h"

namespace lamina {
namespace {

using namespace terminal;

void add_table(Lines& lines, const std::vector<const SummaryRow*>& rows) {
  std::vector<Cells> table = {summary_columns(false)};  // the columns against the truth are too many for a terminal
  for (const SummaryRow* row : rows) {
    table.push_back(summary_cells(*row, false));
    for (std::string& cell : table.back()) cell = one_line(cell);
  }
  const std::vector<size_t> widths = column_widths(table);
  std::vector<bool> figures(widths.size(), true);
  figures[0] = figures[1] = figures.back() = false;
  lines.add(aligned(table[0], widths, figures), dim);
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::string trouble = trouble_of(*rows[i]);
    lines.add(aligned(table[i + 1], widths, figures), !trouble.empty() ? red : rows[i]->baseline ? bold : "");
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
