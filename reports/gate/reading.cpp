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

GateReading::Rows& rows_for(GateReading& reading, const std::string& verdict) {
  if (verdict == "slower" || verdict == "worse" || verdict == "failed") return reading.regressed;
  if (verdict == "ambiguous") return reading.ambiguous;
  if (verdict == "not_compared") return reading.not_compared;
  if (verdict == "faster" || verdict == "better") return reading.improved;
  return reading.same;
}

std::string percent(double ratio) { return fmt::format("{:+.1f}%", 100 * (ratio - 1)); }

// Counts have all their digits, for one fetch more is a change.
std::string words_for_number(double value) {
  return std::abs(value) < 1e15 && value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string words_for_figure(const Json& value, const std::string& what) {
  return what == "time" ? words_for_ms(value.get<double>()) : words_for_number(value.get<double>());
}

std::string trouble_of(const Record& record, const GateReading& reading) {
  if (const std::string cut = text_at(record.run, "/truncated"); !cut.empty())
    return "the record is cut short, so this is no pass: " + cut;
  if (record.gates.empty()) return "the gate did not end, so this is no pass; run it again";
  const Json& gate = record.gates.back();
  const std::string verdict = gate.at("verdict");
  const bool says_well = gate.at("status") == 0 && (verdict == "same" || verdict == "faster");
  if (says_well && reading.same.empty() && reading.improved.empty() && reading.regressed.empty() && reading.ambiguous.empty())
    return "nothing was compared, so this is no pass";
  if (says_well && !reading.regressed.empty()) return "the gate says that all is well, yet figures regressed";
  if (says_well && !reading.ambiguous.empty()) return "the gate says that all is well, yet figures are ambiguous";
  if (gate.at("status") == 0 && !says_well) return fmt::format("the gate's verdict is {}, yet its status is 0", verdict);
  if (gate.at("status") != 0 && reading.regressed.empty() && reading.ambiguous.empty())
    return fmt::format("the gate's verdict is {} with status {}, but no figure justifies it", verdict,
                       gate.at("status").dump());
  return "";
}

std::string counts_of(const Record& record, const GateReading& reading) {
  std::vector<std::string> parts;
  const auto add = [&](const GateReading::Rows& rows, const char* what) {
    if (!rows.empty()) parts.push_back(fmt::format("{} {}", rows.size(), what));
  };
  add(reading.regressed, "regressed");
  add(reading.ambiguous, "ambiguous");
  add(reading.not_compared, "not compared");
  add(reading.improved, "better");
  add(reading.same, "the same");
  return fmt::format("{} check{}: {}", record.verdicts.size(), record.verdicts.size() == 1 ? "" : "s",
                     parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", ")));
}

std::string conditions_of(const Json& gate) {
  const std::string against = text_at(gate, "/against");
  const double wall_s = gate.at("wall_s");
  if (gate.at("rounds") == 0) return fmt::format("against {}; no times were measured, {:.1f} s", against, wall_s);
  return fmt::format("against {}; {} rounds in {} process{}, {:.1f} s; margin {:.3g}%, confidence {:.3g}% over {} comparisons",
                     against, text_at(gate, "/rounds"), text_at(gate, "/processes"), gate.at("processes") == 1 ? "" : "es",
                     wall_s, 100 * gate.at("margin").get<double>(), 100 * gate.at("confidence").get<double>(),
                     text_at(gate, "/comparisons"));
}

}  // namespace

GateReading reading_of(const Record& record) {
  GateReading reading;
  for (const Json& verdict : record.verdicts) rows_for(reading, verdict.at("verdict")).push_back(&verdict);
  for (const Json& aa : record.aas)
    if (aa.at("verdict") == "faster" || aa.at("verdict") == "slower") reading.unequal_aas.push_back(&aa);
  reading.counts = counts_of(record, reading);
  reading.trouble = trouble_of(record, reading);
  if (record.gates.empty()) {
    reading.word = "NO VERDICT";
    return reading;
  }
  const Json& gate = record.gates.back();
  reading.well = gate.at("status") == 0 && reading.trouble.empty();
  reading.word = reading.well                                                     ? "passed"
                 : gate.at("verdict") == "ambiguous" && reading.regressed.empty() ? "AMBIGUOUS"
                                                                                  : "FAILED";
  reading.conditions = conditions_of(gate);
  if (std::ranges::any_of(reading.ambiguous, [](const Json* row) { return row->at("what") == "time"; }))
    reading.conditions += "; ambiguous times want more --budget, a quieter machine or a wider max_slowdown";
  return reading;
}

GateReading::Rows GateReading::all() const {
  Rows rows;
  for (const Rows* group : {&regressed, &ambiguous, &not_compared, &improved, &same})
    rows.insert(rows.end(), group->begin(), group->end());
  return rows;
}

std::vector<std::string> gate_lines(const Record& record) {
  if (record.gates.empty() && record.verdicts.empty()) return {};
  const GateReading reading = reading_of(record);
  std::vector<std::string> lines = {fmt::format("gate {}: {}", reading.word, reading.counts)};
  for (const std::string& line : {reading.trouble, reading.conditions})
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string place_of(const Json& verdict) {
  std::string words;
  for (const char* field : {"view", "pass", "texture"})
    if (const std::string name = verdict.at(field); !name.empty())
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", field, name);
  return words;
}

std::string subject_of(const Json& verdict) {
  const std::string variant = text_at(verdict, "/variant"), backend = text_at(verdict, "/backend"), place = place_of(verdict);
  return fmt::format("{}{}{}{}{}", variant, variant.empty() || backend.empty() ? "" : " on ", backend,
                     place.empty() ? "" : ", ", place);
}

std::string before_and_after(const Json& verdict) {
  const Json &before = verdict.at("before"), &after = verdict.at("after");
  if (before.is_null() && after.is_null()) return "";
  const std::string what = verdict.at("what");
  const char* unit = what == "time" ? " ms" : "";
  if (before.is_null()) return fmt::format("now {}{}", words_for_figure(after, what), unit);
  if (after.is_null()) return fmt::format("was {}{}", words_for_figure(before, what), unit);
  return fmt::format("{} -> {}{}", words_for_figure(before, what), words_for_figure(after, what), unit);
}

std::string change_of(const Json& verdict) {
  if (const auto ratio = interval_of(verdict.at("ratio")))
    return fmt::format("{} [{}, {}]", percent(ratio->median), percent(ratio->low), percent(ratio->high));
  if (verdict.at("before").is_null() || verdict.at("after").is_null()) return "";
  const double before = verdict.at("before"), after = verdict.at("after");
  if (verdict.at("what") == "fetches" && before > 0) return percent(after / before);
  return fmt::format("{:+.3g}", after - before);
}

std::string certainty_of(const Json& verdict) {
  if (const auto ratio = interval_of(verdict.at("ratio")))
    return fmt::format("{:.1f}% interval, {} samples", 100 * ratio->coverage, ratio->rounds);
  return verdict.at("before").is_null() || verdict.at("after").is_null() ? "" : "exact";
}

std::string limit_of(const Json& verdict) {
  return verdict.at("limit").is_null() ? "" : words_for_number(verdict.at("limit").get<double>());
}

std::array<std::string, gate_columns.size()> gate_cells(const Json& verdict) {
  return {text_at(verdict, "/verdict"), text_at(verdict, "/what"), text_at(verdict, "/effect"), text_at(verdict, "/variant"),
          text_at(verdict, "/backend"), place_of(verdict),         before_and_after(verdict),   change_of(verdict),
          certainty_of(verdict),        limit_of(verdict)};
}

std::string words_for_aa(const Json& aa) {
  const Interval ratio = *interval_of(aa.at("ratio"));
  return fmt::format("A/A {} on {}: {}, {} samples: {}", text_at(aa, "/variant"), text_at(aa, "/backend"),
                     words_for_ratio(ratio), ratio.rounds, text_at(aa, "/verdict"));
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
