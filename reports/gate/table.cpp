// SPDX-License-Identifier: Apache-2.0
// The gate's answer for a terminal of some 130 columns.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/terminal.h"
#include "reports/words.h"

namespace lamina {
namespace {

using namespace terminal;

void add_rows(Lines& lines, const char* title, const GateReading::Rows& rows, Mark mark, bool several_effects, bool sentences) {
  if (rows.empty()) return;
  lines.add("");
  lines.add(title, bold);
  Table table = {.columns = std::vector<Column>(10)};
  table.columns[6].right = table.columns[7].right = true;  // before and after, and the change
  for (const VerdictRow* row : rows) {
    const std::string limit = limit_of(*row);
    table.rows.push_back(
        row_of({std::string(name_of(row->verdict)), row->what, std::string(kind_of(*row)),
                several_effects ? fmt::format("{}/{}", row->effect, row->variant) : row->variant, row->backend, place_of(*row),
                before_and_after(*row), change_of(*row), certainty_of(*row), limit.empty() ? "" : "limit " + limit},
               mark));
    if (sentences) table.rows.back().note = sentence_of(*row);
  }
  lines.add(table, "  ");
}

// What was not compared is many rows for few reasons.
void add_not_compared(Lines& lines, const GateReading::Rows& rows) {
  std::map<std::string, size_t> reasons;
  for (const VerdictRow* row : rows) ++reasons[one_line(sentence_of(*row))];
  if (!rows.empty()) lines.add("");
  for (const auto& [reason, count] : reasons) lines.add(fmt::format("not compared ({}): {}", count, reason), yellow);
}

}  // namespace

std::string gate_table(const Record& record, bool colours) {
  const GateReading reading = reading_of(record);
  std::set<std::string> effects;
  for (const VerdictRow& row : record.verdicts) effects.insert(row.effect);
  const bool several = effects.size() > 1;

  Lines lines(colours);
  const bool unsure = reading.word == "AMBIGUOUS";
  lines.add(fmt::format("gate {}: {}", reading.word, reading.counts), reading.well ? green : unsure ? yellow : red);
  if (!reading.trouble.empty()) lines.add(one_line(reading.trouble), red);
  if (!reading.conditions.empty()) lines.add(one_line(reading.conditions), dim);
  add_rows(lines, "regressed", reading.regressed, Mark::bad, several, true);
  add_rows(lines, "ambiguous", reading.ambiguous, Mark::doubtful, several, true);
  add_rows(lines, "time open: every count is equal or fewer", reading.open, Mark::none, several, false);
  add_not_compared(lines, reading.not_compared);
  add_rows(lines, "better", reading.improved, Mark::good, several, false);
  lines.add("");
  if (!reading.same.empty())
    lines.add(fmt::format("{} check{} the same", reading.same.size(), reading.same.size() == 1 ? " is" : "s are"));
  for (const SameArmRow& aa : record.aas) lines.add(one_line(words_for_aa(aa)), dim);
  const bool timed = std::ranges::any_of(record.verdicts, [](const VerdictRow& row) { return row.ratio.has_value(); });
  if (record.aas.empty() && timed) lines.add("no A/A arm was run: how far these times can be believed is not known", yellow);
  if (!timed) lines.add("no times were judged", dim);
  if (!reading.unequal_aas.empty())
    lines.add("warning: a variant came out unlike itself: the machine was not quiet, so doubt the times above", yellow);
  for (const std::string& device : device_lines(record)) lines.add(one_line(device), dim);
  for (const std::string& warning : warnings_of(record)) lines.add("warning: " + one_line(warning), yellow);
  return lines.take();
}

}  // namespace lamina
