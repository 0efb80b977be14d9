// SPDX-License-Identifier: Apache-2.0
// The page's section on a gate: what regressed, what is ambiguous, what got better, each in a sentence; then every check.
#include "reports/html/html.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/gate/reading.h"
#include "reports/gate/strips.h"

namespace lamina {
namespace {

constexpr size_t max_open_sentences = 20;  // sentences; more of them are folded away

std::string sentences(const char* title, const GateReading::Rows& rows, bool open) {
  if (rows.empty()) return "";
  std::string html = fmt::format("<details class=\"verdicts printed\"{}><summary>{}: {}</summary>\n<ul>\n", open ? " open" : "",
                                 title, rows.size());
  for (const VerdictRow* row : rows)
    html += fmt::format("<li><strong>{}</strong> ({}) {}</li>\n", name_of(row->verdict), escaped_html(row->what),
                        escaped_html(row->sentence));
  return html + "</ul></details>\n";
}

std::string verdict_row(const VerdictRow& verdict, bool bad) {
  const auto cells = gate_cells(verdict);
  std::string html = fmt::format("<tr{}><th scope=\"row\">{}</th>", bad ? " class=\"bad\"" : "", escaped_html(cells[0]));
  for (size_t i = 1; i < cells.size(); ++i)
    html += fmt::format("<td{}>{}</td>", i == 5 ? " class=\"wrap\"" : i > 5 ? " class=\"num\"" : "", escaped_html(cells[i]));
  return html + "</tr>\n";
}

// Of the ratio less 1; never -0.
double hundredths_of_percent(const RatioEstimate& estimate) {
  return std::round(1e4 * std::expm1(estimate.log_ratio)) / 100 + 0.0;
}

// What each process measured of every ratio that was judged, and of the A/A arms.
std::string processes_table(const std::vector<GateStrips>& all) {
  if (all.empty()) return "";
  constexpr std::array<const char*, 3> columns = {"comparison", "all processes", "each, with its standard error"};
  std::string html = fmt::format(
      "<details class=\"printed\"><summary>What each process measured</summary>\n<div class=\"scroll\" tabindex=\"0\" "
      "role=\"region\" aria-label=\"What each process measured\"><table><caption>Change of the time, by the strips of one "
      "process at a time. Processes that differ by more than their errors widen the interval of all.</caption>{}<tbody>\n",
      header_row(columns, 3));
  for (const GateStrips& strips : all) {
    std::string each;
    for (const GateStrips::Process& process : strips.processes)
      each += fmt::format("{}{:+.2f}% &plusmn; {:.2f}%", each.empty() ? "" : ", ", hundredths_of_percent(process.estimate),
                          100 * process.estimate.error);
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"wrap\">{}</td></tr>\n",
                        escaped_html(words_for_comparison(strips)),
                        strips.verdict ? escaped_html(change_of(*strips.verdict)) : "", each);
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string html_gate_answer(const Record& record) {
  const std::vector<std::string> lines = gate_lines(record);
  if (lines.empty()) return "";
  const GateReading reading = reading_of(record);
  std::string html = fmt::format("<div class=\"verdict{}\"><p><strong>{}</strong></p>\n", reading.well ? "" : " unwell",
                                 escaped_html("G" + lines[0].substr(1)));
  for (size_t i = 1; i < lines.size(); ++i) html += fmt::format("<p class=\"note\">{}</p>\n", escaped_html(lines[i]));
  return html + "</div>\n";
}

std::string html_gate(const Record& record) {
  if (record.gates.empty() && record.verdicts.empty()) return "";
  const GateReading reading = reading_of(record);
  std::string html = "<h2>What the gate found</h2>\n";
  html += sentences("Regressed", reading.regressed, true) +
          sentences("Ambiguous", reading.ambiguous, reading.ambiguous.size() <= max_open_sentences) +
          sentences("Not compared", reading.not_compared, reading.not_compared.size() <= max_open_sentences) +
          sentences("Better", reading.improved, reading.improved.size() <= max_open_sentences);
  if (record.verdicts.empty()) return html;
  html += fmt::format(
      "<details class=\"printed\"{2}><summary>All {0} checks</summary>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"All {0} "
      "checks\"><table class=\"wide\"><caption>Change: of a time the ratio to before with its interval, of fetches the "
      "share, of other figures the difference. Limit: what was allowed; of a time the margin.</caption>{1}<tbody>\n",
      record.verdicts.size(), header_row(gate_columns, 6), record.verdicts.size() <= max_open_sentences ? " open" : "");
  for (size_t i = 0; const VerdictRow* row : reading.all()) html += verdict_row(*row, i++ < reading.regressed.size());
  return html + "</tbody></table></div></details>\n" + processes_table(gate_strips(record));
}

}  // namespace lamina
