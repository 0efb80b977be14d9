// SPDX-License-Identifier: Apache-2.0
// Records of a gate made by hand.
#pragma once

#include "tests/reports/example_record.h"

namespace lamina {

inline nlohmann::json example_interval(double median, double low, double high) {
  return {{"median", median}, {"low", low}, {"high", high}, {"rounds", 60}, {"coverage", 0.961}};
}

inline nlohmann::json example_verdict(const std::string& verdict, const std::string& what, const std::string& sentence) {
  nlohmann::json line = {{"kind", "verdict"},
                         {"backend", "vulkan"},
                         {"effect", "layered_material"},
                         {"variant", "vertex_normal"},
                         {"view", ""},
                         {"what", what},
                         {"pass", ""},
                         {"texture", ""},
                         {"verdict", verdict},
                         {"before", nullptr},
                         {"after", nullptr},
                         {"ratio", nullptr},
                         {"limit", nullptr},
                         {"sentence", sentence}};
  return line;
}

// A pass from 10 to 11 ms.
inline nlohmann::json example_slower() {
  nlohmann::json line = example_verdict("slower", "time", "the composite pass takes 10% longer");
  line["pass"] = "composite";
  line["before"] = 10.0;
  line["after"] = 11.0;
  line["ratio"] = example_interval(1.1, 1.08, 1.12);
  line["limit"] = 0.03;
  return line;
}
inline nlohmann::json example_fetches() {
  nlohmann::json line = example_verdict("worse", "fetches", "one tap more");
  line["view"] = "front";
  line["pass"] = "composite";
  line["texture"] = "light_map_texture";
  line["before"] = 1300;
  line["after"] = 1400;
  return line;
}
inline nlohmann::json example_gate_line(const std::string& verdict, int status) {
  return {{"kind", "gate"},     {"mode", "against"}, {"against", "the main branch"},
          {"verdict", verdict}, {"status", status},  {"processes", 3},
          {"rounds", 60},       {"wall_s", 41.25},   {"margin", 0.02},
          {"confidence", 0.95}, {"comparisons", 12}};
}
inline nlohmann::json example_aa(const std::string& verdict) {
  return {{"kind", "aa"},
          {"backend", "vulkan"},
          {"effect", "layered_material"},
          {"variant", "vertex_normal"},
          {"ratio", example_interval(1.001, 0.997, 1.004)},
          {"verdict", verdict}};
}

inline Record example_gate(const std::string& verdict, int status, std::vector<nlohmann::json> verdicts) {
  Record record = example_record({});
  record.run["date"] = "2026-01-31T23:59:59Z";
  record.gates = {example_gate_line(verdict, status)};
  record.aas = {example_aa("same")};
  record.verdicts = std::move(verdicts);
  return record;
}
inline Record example_failed_gate() {
  return example_gate("slower", 1,
                      {example_verdict("same", "ssim", "unchanged"), example_slower(), example_fetches(),
                       example_verdict("ambiguous", "time", "the interval reaches over the margin"),
                       example_verdict("not_compared", "time", "another machine"), example_verdict("better", "flip", "lower")});
}
inline Record example_passed_gate() { return example_gate("same", 0, {example_verdict("same", "ssim", "unchanged")}); }

}  // namespace lamina
