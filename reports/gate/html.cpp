// SPDX-License-Identifier: Apache-2.0
// The page's section on a gate: what regressed, what is ambiguous, what got better, each in a sentence; then every check.
#include "reports/html/html.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/gate/strips.h"

namespace lamina {
namespace {

constexpr size_t max_open_sentences = 20;  // sentences; more of them are folded away

std::string sentences(const char* title, const GateReading::Rows& rows, bool open) {
  if (rows.empty()) return "";
  std::string html = fmt::format("<details class=\"verdicts printed\"{}><summary>{}: {}</summary>\n<ul>\n", open ? " open" : "",
                                 title, rows.size());
  for (const VerdictRow* row : rows)
    html += fmt::format("<li><strong>{}</strong> ({}, {}) {}</li>\n", name_of(row->verdict), escaped_html(row->what),
                        kind_of(*row), escaped_html(sentence_of(*row)));
  return html + "</ul></details>\n";
}

// Of the ratio less 1; never -0.
double hundredths_of_percent(const RatioEstimate& estimate) {
  return std::round(1e4 * std::expm1(estimate.log_ratio)) / 100 + 0.0;
}

// What each process measured of every ratio that was judged, and of the A/A arms.
std::string processes_table(const std::vector<GateStrips>& all) {
  if (all.empty()) return "";
  Table table = {.caption =
                     "Change of the time, by the strips of one process at a time. Processes that differ by more than their "
                     "errors widen the interval of all.",
                 .columns = {words_column("comparison"), words_column("all processes"),
                             words_column("each, with its standard error", "wrap")},
                 .label = "What each process measured"};
  for (const GateStrips& strips : all) {
    Row& row =
        table.rows.emplace_back(row_of({words_for_comparison(strips), strips.verdict ? change_of(*strips.verdict) : "", ""}));
    for (std::string& each = row.cells.back().html; const GateStrips::Process& process : strips.processes)
      each += fmt::format("{}{:+.2f}% &plusmn; {:.2f}%", each.empty() ? "" : ", ", hundredths_of_percent(process.estimate),
                          100 * process.estimate.error);
  }
  return fmt::format("<details class=\"printed\"><summary>{}</summary>\n{}</details>\n", table.label, html_table(table));
}

}  // namespace

std::string html_gate_answer(const Record& record) {
  if (record.gates.empty() && record.verdicts.empty()) return "";
  const GateReading reading = reading_of(record);
  std::string html = fmt::format("<div class=\"verdict{}\"><p><strong>Gate {}: {}</strong></p>\n",
                                 reading.well ? "" : " unwell", reading.word, escaped_html(reading.counts));
  for (const std::string& line : {reading.trouble, reading.conditions})
    if (!line.empty()) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(line));
  return html + "</div>\n";
}

std::string html_gate(const Record& record) {
  if (record.gates.empty() && record.verdicts.empty()) return "";
  const GateReading reading = reading_of(record);
  std::string html = "<h2>What the gate found</h2>\n";
  html += sentences("Regressed", reading.regressed, true) +
          sentences("Ambiguous", reading.ambiguous, reading.ambiguous.size() <= max_open_sentences) +
          sentences("Time open", reading.open, false) +
          sentences("Not compared", reading.not_compared, reading.not_compared.size() <= max_open_sentences) +
          sentences("Better", reading.improved, reading.improved.size() <= max_open_sentences);
  if (record.verdicts.empty()) return html;
  Table table = verdicts_table(reading);
  table.caption =
      "Change: of a time the ratio to before with its interval, of fetches the share, of other figures the difference. Limit: "
      "what was allowed; of a time the margin.";
  table.label = fmt::format("All {} checks", record.verdicts.size());
  html += fmt::format("<details class=\"printed\"{}><summary>{}</summary>\n{}</details>\n",
                      record.verdicts.size() <= max_open_sentences ? " open" : "", table.label, html_table(table));
  return html + processes_table(gate_strips(record));
}

}  // namespace lamina
