// SPDX-License-Identifier: Apache-2.0
// A gate's answer and a sweep's crossovers in words: the same for the page and for Markdown.
#include <fmt/format.h>

#include "reports/words.h"

namespace lamina {
namespace {

using Json = nlohmann::json;

std::string subject_of(const Json& line) {
  std::string words;
  for (const char* field : {"variant", "effect", "backend", "view", "pass", "texture"})
    if (const std::string value = text_at(line, (std::string("/") + field).c_str()); !value.empty())
      words += fmt::format(
          "{}{}{}", words.empty() ? "" : ", ",
          std::string_view(field) == "view" || std::string_view(field) == "pass" || std::string_view(field) == "texture"
              ? std::string(field) + " "
              : "",
          value);
  return words;
}

std::string figure(const Json& value) { return value.is_null() ? "-" : fmt::format("{:.6g}", value.get<double>()); }

std::string ratio(const Json& line) {
  const auto interval = interval_of(line.at("ratio"));
  return interval ? words_for_ratio(*interval) : "-";
}

}  // namespace

std::vector<std::string> gate_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const Json& gate : record.gates) {
    const std::string verdict = gate.at("verdict");
    const char* meaning = verdict == "same"        ? "nothing got measurably slower, faster or worse"
                          : verdict == "faster"    ? "something got faster, nothing slower or worse"
                          : verdict == "slower"    ? "something got slower"
                          : verdict == "failed"    ? "a limit is broken, or something could not be measured"
                          : verdict == "ambiguous" ? "the measurement cannot tell; run it again on a quieter machine"
                                                   : "see the table";
    lines.push_back(fmt::format(
        "the gate says {}: {}; against {}, {} comparisons in {} rounds of {} processes, {:.0f} s, margin {:.3g}%, confidence "
        "{:.3g}%, exit status {}",
        verdict, meaning, text_at(gate, "/against"), text_at(gate, "/comparisons"), text_at(gate, "/rounds"),
        text_at(gate, "/processes"), gate.at("wall_s").get<double>(), 100 * gate.at("margin").get<double>(),
        100 * gate.at("confidence").get<double>(), text_at(gate, "/status")));
  }
  return lines;
}

std::vector<std::array<std::string, gate_columns.size()>> gate_rows(const Record& record) {
  std::vector<std::array<std::string, gate_columns.size()>> rows;
  for (const Json& line : record.verdicts)
    rows.push_back({subject_of(line), text_at(line, "/what"), text_at(line, "/verdict"), figure(line.at("before")),
                    figure(line.at("after")), ratio(line), figure(line.at("limit")), text_at(line, "/sentence")});
  return rows;
}

std::vector<std::string> aa_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const Json& line : record.aas)
    lines.push_back(fmt::format("{} against itself: {}, ratio {}", subject_of(line), text_at(line, "/verdict"), ratio(line)));
  return lines;
}

std::vector<std::string> crossover_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const Json& line : record.crossovers)
    lines.push_back(
        fmt::format("{} on {}: {}", text_at(line, "/effect"), text_at(line, "/backend"), text_at(line, "/sentence")));
  return lines;
}

std::vector<std::string> sweep_lines(const Record& record) {
  std::vector<std::string> lines;
  for (const Json& sweep : record.sweeps)
    for (const Json& parameter : sweep.at("parameters")) {
      const Json& values = parameter.at("values");
      std::string words = text_at(parameter, "/path");
      if (!values.empty())
        words += fmt::format(" from {} to {}{}{} in {} values", values.front().dump(), values.back().dump(),
                             text_at(parameter, "/unit").empty() ? "" : " ", text_at(parameter, "/unit"), values.size());
      lines.push_back(words);
    }
  return lines;
}

}  // namespace lamina
