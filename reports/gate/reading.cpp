// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/reading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/words.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

GateReading::Rows& rows_for(GateReading& reading, Verdict verdict) {
  switch (verdict) {
    case Verdict::slower:
    case Verdict::worse:
    case Verdict::failed:
      return reading.regressed;
    case Verdict::ambiguous:
      return reading.ambiguous;
    case Verdict::time_open:
      return reading.open;
    case Verdict::not_compared:
      return reading.not_compared;
    case Verdict::faster:
    case Verdict::better:
      return reading.improved;
    case Verdict::same:
      break;
  }
  return reading.same;
}

// Counts have all their digits, for one fetch more is a change.
std::string words_for_number(double value) {
  return std::abs(value) < 1e15 && value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string words_for_figure(double value, const std::string& what) {
  return what == "time" ? words_for_ms(value) : words_for_number(value);
}

std::string trouble_of(const Record& record, const GateReading& reading) {
  if (const std::string cut = text_at(record.run, "/truncated"); !cut.empty())
    return "the record is cut short, so this is no pass: " + cut;
  if (record.gates.empty()) return "the gate did not end, so this is no pass; run it again";
  const GateRow& gate = record.gates.back();
  const bool says_well = gate.status == 0 && (gate.verdict == Verdict::same || gate.verdict == Verdict::faster);
  if (says_well && reading.same.empty() && reading.improved.empty() && reading.regressed.empty() && reading.ambiguous.empty())
    return "nothing was compared, so this is no pass";
  if (says_well && !reading.regressed.empty()) return "the gate says that all is well, yet figures regressed";
  if (says_well && !reading.ambiguous.empty()) return "the gate says that all is well, yet figures are ambiguous";
  if (gate.status == 0 && !says_well)
    return fmt::format("the gate's verdict is {}, yet its status is 0", name_of(gate.verdict));
  if (gate.status != 0 && reading.regressed.empty() && reading.ambiguous.empty())
    return fmt::format("the gate's verdict is {} with status {}, but no figure justifies it", name_of(gate.verdict),
                       gate.status);
  return "";
}

std::string counts_of(const Record& record, const GateReading& reading) {
  std::vector<std::string> parts;
  const auto add = [&](const GateReading::Rows& rows, const char* what) {
    if (!rows.empty()) parts.push_back(fmt::format("{} {}", rows.size(), what));
  };
  add(reading.regressed, "regressed");
  add(reading.ambiguous, "ambiguous");
  add(reading.open, "with its time open");
  add(reading.not_compared, "not compared");
  add(reading.improved, "better");
  add(reading.same, "the same");
  return fmt::format("{} check{}: {}", record.verdicts.size(), record.verdicts.size() == 1 ? "" : "s",
                     parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", ")));
}

std::string conditions_of(const GateRow& gate) {
  if (gate.rounds == 0) return fmt::format("against {}; no times were measured, {:.1f} s", gate.against, gate.wall_s);
  return fmt::format("against {}; {} rounds in {} process{}, {:.1f} s; margin {:.3g}%, confidence {:.3g}% over {} comparisons",
                     gate.against, gate.rounds, gate.processes, gate.processes == 1 ? "" : "es", gate.wall_s, 100 * gate.margin,
                     100 * gate.confidence, gate.comparisons);
}

}  // namespace

GateReading reading_of(const Record& record) {
  GateReading reading;
  for (const VerdictRow& row : record.verdicts) rows_for(reading, row.verdict).push_back(&row);
  for (const SameArmRow& aa : record.aas)
    if (aa.verdict == Verdict::faster || aa.verdict == Verdict::slower) reading.unequal_aas.push_back(&aa);
  reading.counts = counts_of(record, reading);
  reading.trouble = trouble_of(record, reading);
  if (record.gates.empty()) {
    reading.word = "NO VERDICT";
    return reading;
  }
  const GateRow& gate = record.gates.back();
  reading.well = gate.status == 0 && reading.trouble.empty();
  reading.word = reading.well                                                      ? "passed"
                 : gate.verdict == Verdict::ambiguous && reading.regressed.empty() ? "AMBIGUOUS"
                                                                                   : "FAILED";
  reading.conditions = conditions_of(gate);
  if (std::ranges::any_of(reading.ambiguous, [](const VerdictRow* row) { return row->what == "time"; }))
    reading.conditions += "; ambiguous times want more --budget, a quieter machine or a wider max_slowdown";
  return reading;
}

std::vector<std::string> gate_lines(const Record& record) {
  if (record.gates.empty() && record.verdicts.empty()) return {};
  const GateReading reading = reading_of(record);
  std::vector<std::string> lines = {fmt::format("gate {}: {}", reading.word, reading.counts)};
  for (const std::string& line : {reading.trouble, reading.conditions})
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string place_of(const VerdictRow& row) {
  std::string words;
  const std::pair<const char*, const std::string&> parts[] = {{"view", row.view}, {"pass", row.pass}, {"texture", row.texture}};
  for (const auto& [what, name] : parts)
    if (!name.empty()) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", what, name);
  return words;
}

std::string subject_of(const VerdictRow& row) {
  const std::string place = place_of(row);
  return fmt::format("{}{}{}{}{}", row.variant, row.variant.empty() || row.backend.empty() ? "" : " on ", row.backend,
                     place.empty() ? "" : ", ", place);
}

std::string before_and_after(const VerdictRow& row) {
  if (!row.before && !row.after) return "";
  const char* unit = row.what == "time" ? " ms" : "";
  if (!row.before) return fmt::format("now {}{}", words_for_figure(*row.after, row.what), unit);
  if (!row.after) return fmt::format("was {}{}", words_for_figure(*row.before, row.what), unit);
  return fmt::format("{} -> {}{}", words_for_figure(*row.before, row.what), words_for_figure(*row.after, row.what), unit);
}

std::string percent(double ratio) { return fmt::format("{:+.1f}%", 100 * (ratio - 1)); }

std::string change_of(const VerdictRow& row) {
  if (row.ratio)
    return fmt::format("{} [{}, {}]", percent(row.ratio->median), percent(row.ratio->low), percent(row.ratio->high));
  if (!row.before || !row.after) return "";
  if (kind_of(row) == "count" && *row.before > 0) return percent(*row.after / *row.before);
  return fmt::format("{:+.3g}", *row.after - *row.before);
}

std::string certainty_of(const VerdictRow& row) {
  if (row.ratio) return fmt::format("{:.1f}% interval, {} samples", 100 * row.ratio->coverage, row.ratio->rounds);
  return row.before && row.after ? "exact" : "";
}

std::string_view kind_of(const VerdictRow& row) {
  const auto is = [&](auto... whats) { return ((row.what == whats) || ...); };
  if (is("time", "ratio", "timer", "frame_ms")) return "interval";
  if (is("fetches", "operations", "fragments", "vertices", "target_bytes")) return "count";
  if (is("code", "cell", "api")) return "code";
  return "picture";
}

std::string limit_of(const VerdictRow& row) { return row.limit ? words_for_number(*row.limit) : ""; }

Table verdicts_table(const GateReading& reading) {
  // How sure stands beside the figures on the page, and is words in Markdown.
  Table table = {.columns = {words_column("verdict"), words_column("what"), words_column("kind"), words_column("effect"),
                             words_column("variant"), words_column("backend"), words_column("where", "wrap"),
                             number_column("before -> after"), number_column("change"), words_column("how sure", "num"),
                             number_column("limit")},
                 .html_class = "wide"};
  for (const GateReading::Rows* rows :
       {&reading.regressed, &reading.ambiguous, &reading.open, &reading.not_compared, &reading.improved, &reading.same})
    for (const VerdictRow* row : *rows)
      table.rows.push_back(
          row_of({std::string(name_of(row->verdict)), row->what, std::string(kind_of(*row)), row->effect, row->variant,
                  row->backend, place_of(*row), before_and_after(*row), change_of(*row), certainty_of(*row), limit_of(*row)},
                 rows == &reading.regressed ? Mark::bad : Mark::none));
  return table;
}

std::string words_for_aa(const SameArmRow& aa) {
  return fmt::format("A/A {} on {}: {}, {} samples: {}", aa.variant, aa.backend, words_for_ratio(aa.ratio), aa.ratio.rounds,
                     name_of(aa.verdict));
}

std::vector<std::string> device_lines(const Record& record) {
  std::vector<std::string> lines;
  const auto devices = record.run.find("devices");
  if (devices == record.run.end() || !devices->is_array()) return lines;
  for (const Json& device : *devices)
    lines.push_back(
        fmt::format("{}: {}, {}", text_at(device, "/backend"), text_at(device, "/device"), text_at(device, "/driver")));
  return lines;
}

}  // namespace lamina
