// SPDX-License-Identifier: Apache-2.0
// The summary as Markdown with GitHub's tables (GitHub Flavored Markdown Spec 0.29, section 4.10).
#include <fmt/format.h>

#include "reports/functions.h"
#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/markdown.h"
#include "reports/sweep/sweep_text.h"

namespace lamina {
namespace {

std::string summary_section(const std::vector<SummaryRow>& rows) {
  std::string text;
  for (const Table& table : summary_tables(rows, true)) text += "\n" + markdown_table(table, "## ");
  text += "\n";
  for (const SummaryRow& row : rows)
    if (const std::string trouble = trouble_of(row); !trouble.empty())
      text += fmt::format("**{} on {}** {}  \n", escaped_markdown(row.variant), escaped_markdown(row.backend),
                          escaped_markdown(trouble));
  for (const std::string& note : summary_notes(rows)) text += fmt::format("{}  \n", escaped_markdown(note));
  return text;
}

std::string passes_section(const std::vector<PassSummary>& passes) {
  if (passes.empty()) return "";
  Table table = passes_table(passes);
  table.caption += ".";
  return "\n## Passes\n\n" + markdown_table(table);
}

std::string assumptions_section(const Record& record) {
  std::string text;
  for (const CellRow& cell : record.cells)
    if (!cell.assumptions.empty())
      text += fmt::format("- {} on {}, view {}: {}\n", escaped_markdown(cell.variant), escaped_markdown(cell.backend),
                          escaped_markdown(cell.view), escaped_markdown(costliest_assumption(cell)));
  return text.empty() ? "" : "\n## Which assumption costs you\n\n" + text;
}

std::string sweep_section(const Record& record) {
  if (record.sweeps.empty()) return "";
  constexpr size_t all_rows = 1000;
  std::string text = "\n## Answers\n\n";
  for (const auto& [effect, words] : crossover_headlines(record))
    text += effect.empty() ? fmt::format("- {}\n", escaped_markdown(words))
                           : fmt::format("- **{}**: {}\n", escaped_markdown(effect), escaped_markdown(words));
  text += "\n## Curves\n\nErrors against the baseline at the same point, the worst view; ratio: time over the baseline's.\n";
  for (const Table& table : curve_tables(curves_of(record), all_rows)) text += "\n" + markdown_table(table);
  return text;
}

// Which cases each variant passes and fails, and the figures of every set.
std::string hard_cases_markdown(const FunctionBackend& backend) {
  const Table table = function_sets_table(backend);
  if (table.rows.empty()) return "";
  std::string text = fmt::format("\n### Hard cases on {}\n\n", escaped_markdown(backend.backend));
  for (const Headline& headline : hard_case_headlines(backend))
    text += fmt::format("- **{}** {}\n", escaped_markdown(headline.variant), escaped_markdown(headline.words));
  return text + "\n" + markdown_table(table);
}

std::string functions_section(const Record& record) {
  std::string text;
  for (const FunctionReport& report : summarize_functions(record)) {
    text += fmt::format("\n## Functions: {}\n\n", escaped_markdown(report.title));
    for (const Headline& headline : function_headlines(report))
      text += fmt::format("- **{}** {}\n", escaped_markdown(headline.variant), escaped_markdown(headline.words));
    for (const FunctionBackend& backend : report.backends) text += "\n" + markdown_table(function_table(report, backend));
    for (const FunctionBackend& backend : report.backends) text += hard_cases_markdown(backend);
    text += "\n";
    for (const std::string& note : function_notes(report)) text += fmt::format("{}  \n", escaped_markdown(note));
  }
  return text;
}

std::string gate_section(const Record& record) {
  if (record.verdicts.empty()) return "";
  const GateReading reading = reading_of(record);
  std::string text = "\n## What the gate found\n\n" + markdown_table(verdicts_table(reading));
  text += "\n";
  for (const GateReading::Rows& rows : {reading.regressed, reading.ambiguous, reading.not_compared})
    for (const auto* row : rows) text += fmt::format("- {}\n", escaped_markdown(sentence_of(*row)));
  return text;
}

std::string saving_section(const Record& record) {
  if (record.savings.empty()) return "";
  std::string text = "\n## What is left out, and what that saves\n\n";
  for (const Headline& headline : saving_headlines(record))
    text += fmt::format("- **{}**: {}\n", escaped_markdown(headline.variant), escaped_markdown(headline.words));
  for (const Table& table : saving_tables(record)) text += "\n" + markdown_table(table);
  return text;
}

std::string list_section(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string text = fmt::format("\n## {}\n\n", title);
  for (const std::string& line : lines) text += fmt::format("- {}\n", escaped_markdown(line));
  return text;
}

}  // namespace

std::string markdown_summary(const Record& record) {
  const std::vector<SummaryRow> rows = summarize(record);
  std::string text = fmt::format("# {}\n\n", escaped_markdown(title_of(record)));
  for (const std::string& warning : warnings_of(record)) text += fmt::format("**Warning:** {}\n\n", escaped_markdown(warning));
  for (const Headline& headline : worth_having(rows))
    text += fmt::format("- **{}**: {}\n", escaped_markdown(headline.variant), escaped_markdown(headline.words));
  for (const std::string& line : gate_lines(record)) text += fmt::format("- {}\n", escaped_markdown(line));
  for (const Headline& headline : failure_headlines(rows))
    text += fmt::format("- **{}** {}\n", escaped_markdown(headline.variant), escaped_markdown(headline.words));
  for (const Table& table : choices_tables(rows)) text += "\n" + markdown_table(table, "## ");
  text += saving_section(record) + sweep_section(record);
  if (!rows.empty()) text += summary_section(rows);
  text += gate_section(record);
  text += assumptions_section(record);
  text += passes_section(summarize_passes(record));
  text += list_section("What is done once", bake_lines(record));
  text += functions_section(record);
  text += list_section("What the scene calls for", plan_lines(record));
  std::vector<std::string> failed, certified, facts;
  for (const auto& [cell, reason] : failures(record)) failed.push_back(cell + ": " + reason);
  for (const Certificate& certificate : certificates(record)) certified.push_back(certificate.words);
  for (const std::string& line : phase_lines(record)) certified.push_back(line);
  for (const auto& [label, value] : run_facts(record)) facts.push_back(label + ": " + value);
  text += list_section("Failures", failed);
  for (const auto& aa : record.aas) certified.push_back(words_for_aa(aa));
  if (!record.aas.empty()) certified.push_back(aa_note);
  text += list_section("Timer", certified);
  text += list_section("What was run", facts);
  return text;
}

}  // namespace lamina
