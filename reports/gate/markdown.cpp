// SPDX-License-Identifier: Apache-2.0
// The gate's answer for a comment on a pull request.
#include "reports/markdown.h"

#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/words.h"

namespace lamina {
namespace {

constexpr size_t max_bytes = 60000;  // a comment on GitHub takes 65,536 characters

// Adds lines while they fit; says how many did not.
void add_while_they_fit(std::string& text, const std::vector<std::string>& lines, size_t room, const char* what) {
  for (size_t i = 0; i < lines.size(); ++i) {
    if (text.size() + lines[i].size() > room) {
      text += fmt::format("\n{} more {} are left out here; gate.json has all.\n", lines.size() - i, what);
      return;
    }
    text += lines[i];
  }
}

void add_section(std::string& text, const char* title, const GateReading::Rows& rows) {
  if (rows.empty()) return;
  text += fmt::format("\n**{}**\n\n", title);
  std::vector<std::string> lines;
  for (const VerdictRow* row : rows)
    lines.push_back(fmt::format("- **{}** ({}, {}) {}\n", escaped_markdown(std::string(name_of(row->verdict))),
                                escaped_markdown(row->what), kind_of(*row), escaped_markdown(sentence_of(*row))));
  add_while_they_fit(text, lines, max_bytes / 2, "of these");
}

}  // namespace

std::string gate_markdown(const Record& record) {
  const GateReading reading = reading_of(record);
  const char* mark = reading.well ? "✅" : reading.word == "AMBIGUOUS" ? "⚠️" : "❌";
  std::string text = fmt::format("### {} Lamina gate {}: {}\n\n", mark, reading.word, escaped_markdown(reading.counts));
  if (!reading.trouble.empty()) text += fmt::format("**{}**\n\n", escaped_markdown(reading.trouble));
  add_section(text, "Regressed", reading.regressed);
  add_section(text, "Ambiguous", reading.ambiguous);
  add_section(text, "Time open", reading.open);
  add_section(text, "Better", reading.improved);
  text += "\n";
  for (const SameArmRow& aa : record.aas) text += fmt::format("{}  \n", escaped_markdown(words_for_aa(aa)));
  if (!reading.unequal_aas.empty()) text += "**A variant came out unlike itself: doubt the times.**  \n";
  if (!reading.conditions.empty()) text += fmt::format("{}  \n", escaped_markdown(reading.conditions));
  for (const std::string& device : device_lines(record)) text += fmt::format("{}  \n", escaped_markdown(device));
  for (const std::string& warning : warnings_of(record)) text += fmt::format("**Warning:** {}  \n", escaped_markdown(warning));
  if (record.verdicts.empty()) return text;

  std::vector<std::string> rows = markdown_lines(verdicts_table(reading));
  text += fmt::format("\n<details><summary>All {} checks</summary>\n\n{}", record.verdicts.size(), rows.front());
  rows.erase(rows.begin());
  add_while_they_fit(text, rows, max_bytes, "rows");
  return text + "\n</details>\n";
}

}  // namespace lamina
