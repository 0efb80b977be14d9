// SPDX-License-Identifier: Apache-2.0
// The gate's answer where GitHub Actions runs it (GitHub Docs, "Workflow commands for GitHub Actions": setting messages, adding
// a job summary; the escapes are those of actions/toolkit's command.ts).
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/gate/sentences.h"
#include "reports/words.h"

namespace lamina {
namespace {

constexpr size_t shown_of_a_kind = 10;  // annotations of one kind that GitHub shows of one step

// In a command's message; in a property the comma and the colon have a meaning too.
std::string escaped(const std::string& text, bool property) {
  std::string out;
  for (const char c : text) {
    const bool special = c == '%' || c == '\r' || c == '\n' || (property && (c == ',' || c == ':'));
    out += special ? fmt::format("%{:02X}", c) : std::string(1, c);
  }
  return out;
}

struct Annotation {
  std::string title, message;
};

std::string commands(const char* kind, const std::vector<Annotation>& annotations) {
  std::string text;
  for (size_t i = 0; i < annotations.size(); ++i) {
    const bool last = i + 1 == shown_of_a_kind && annotations.size() > shown_of_a_kind;
    const Annotation annotation =
        last ? Annotation{"Lamina gate", fmt::format("{} more are in the job's summary", annotations.size() - i)}
             : annotations[i];
    text += fmt::format("::{} title={}::{}\n", kind, escaped(annotation.title, true), escaped(annotation.message, false));
    if (last) break;
  }
  return text;
}

Annotation annotation_of(const VerdictRow& row) {
  return {fmt::format("{}: {} ({}): {}", name_of(row.verdict), row.what, kind_of(row), subject_of(row)), sentence_of(row)};
}

}  // namespace

std::string github_annotations(const Record& record) {
  const GateReading reading = reading_of(record);
  std::vector<Annotation> errors, warnings;
  if (!reading.trouble.empty()) errors.push_back({"Lamina gate " + reading.word, reading.trouble});
  for (const VerdictRow* row : reading.regressed) errors.push_back(annotation_of(*row));
  for (const VerdictRow* row : reading.ambiguous) warnings.push_back(annotation_of(*row));
  for (const SameArmRow* aa : reading.unequal_aas)
    warnings.push_back({"A variant came out unlike itself", words_for_aa(*aa) + "; doubt the times"});
  return commands("error", errors) + commands("warning", warnings);
}

void announce_on_github(const Record& record) {
  const char* actions = std::getenv("GITHUB_ACTIONS");
  if (!actions || std::string(actions) != "true") return;
  fmt::print("{}", github_annotations(record));
  const char* summary = std::getenv("GITHUB_STEP_SUMMARY");
  if (!summary || !*summary) return;
  std::ofstream file(summary, std::ios::app | std::ios::binary);
  file << gate_markdown(record) << std::flush;
  if (!file)
    fmt::print("::warning title=Lamina gate::{}\n", escaped(fmt::format("the summary {} cannot be written", summary), false));
}

}  // namespace lamina
