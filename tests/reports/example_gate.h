// SPDX-License-Identifier: Apache-2.0
// Records of a gate made by hand.
#pragma once

#include "tests/reports/example_record.h"

namespace lamina {

inline Interval example_interval(double median, double low, double high) { return {median, low, high, 60, 0.961}; }

inline VerdictRow example_verdict(Verdict verdict, const std::string& what, const std::string& sentence) {
  VerdictRow row;
  row.backend = "vulkan", row.effect = "layered_material", row.variant = "vertex_normal";
  row.what = what, row.verdict = verdict, row.sentence = sentence;
  return row;
}

// A pass from 10 to 11 ms.
inline VerdictRow example_slower() {
  VerdictRow row = example_verdict(Verdict::slower, "time", "the composite pass takes 10% longer");
  row.pass = "composite";
  row.before = 10, row.after = 11, row.limit = 0.03;
  row.ratio = example_interval(1.1, 1.08, 1.12);
  return row;
}
inline VerdictRow example_fetches() {
  VerdictRow row = example_verdict(Verdict::worse, "fetches", "one tap more");
  row.view = "front", row.pass = "composite", row.texture = "light_map_texture";
  row.before = 1300, row.after = 1400;
  return row;
}
inline GateRow example_gate_row(Verdict verdict, int status) {
  return {.mode = "against",
          .against = "the main branch",
          .verdict = verdict,
          .status = status,
          .processes = 3,
          .rounds = 60,
          .comparisons = 12,
          .wall_s = 41.25,
          .margin = 0.02,
          .confidence = 0.95};
}
inline SameArmRow example_aa(Verdict verdict) {
  return {"vulkan", "layered_material", "vertex_normal", example_interval(1.001, 0.997, 1.004), verdict};
}

inline Record example_gate(Verdict verdict, int status, std::vector<VerdictRow> verdicts) {
  Record record = example_record({});
  record.run["date"] = "2026-01-31T23:59:59Z";
  record.gates = {example_gate_row(verdict, status)};
  record.aas = {example_aa(Verdict::same)};
  record.verdicts = std::move(verdicts);
  return record;
}
inline Record example_failed_gate() {
  return example_gate(
      Verdict::slower, 1,
      {example_verdict(Verdict::same, "ssim", "unchanged"), example_slower(), example_fetches(),
       example_verdict(Verdict::ambiguous, "time", "the interval reaches over the margin"),
       example_verdict(Verdict::not_compared, "time", "another machine"), example_verdict(Verdict::better, "flip", "lower")});
}
inline Record example_passed_gate() {
  return example_gate(Verdict::same, 0, {example_verdict(Verdict::same, "ssim", "unchanged")});
}

}  // namespace lamina
