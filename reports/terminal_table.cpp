// SPDX-License-Identifier: Apache-2.0
// The table that a run ends with, for a terminal of some 130 columns.
#include "reports/terminal.h"
#include "reports/words.h"

namespace lamina {

std::string terminal_table(const Record& record, bool colour) {
  using namespace terminal;
  Lines lines(colour);
  lines.add(one_line(title_of(record)), bold);
  const std::vector<SummaryRow> rows = summarize(record);
  for (const Headline& headline : saving_headlines(record)) lines.add(headline.variant + ": " + one_line(headline.words));
  for (const Table& table : saving_tables(record)) {
    lines.add("");
    lines.add(table);
  }
  for (Table& table : summary_tables(rows, false)) {  // the columns against the truth are too many for a terminal
    for (Row& row : table.rows)
      if (!row.note.empty()) row.mark = row.note_mark = Mark::bad;
    lines.add("");
    lines.add(table);
  }
  lines.add("");
  for (const std::string& note : summary_notes(rows)) lines.add(note, dim);
  for (const Certificate& certificate : certificates(record))
    if (certificate.ok) lines.add("timer: " + one_line(certificate.words), dim);
  for (const std::string& warning : warnings_of(record)) lines.add("warning: " + one_line(warning), yellow);
  return lines.take();
}

}  // namespace lamina
