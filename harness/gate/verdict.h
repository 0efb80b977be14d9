// SPDX-License-Identifier: Apache-2.0
// One line of a gate's result: what was looked at, and whether it is the same as before.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "harness/measure/statistics.h"

namespace lamina {

enum class Verdict : uint8_t {
  same,
  faster,        // a time, beyond the margin
  better,        // anything else that improved
  not_compared,  // there is nothing to compare with: neither a pass nor a failure
  ambiguous,     // the interval reaches over the margin
  slower,
  worse,
  failed,  // a limit of its own, or a cell that cannot be measured
};
std::string_view name_of(Verdict verdict);

struct VerdictRow {
  std::string backend, effect, variant, view;  // view: "" for all of them
  std::string what;                            // "time", "fetches", "ssim", ...
  std::string pass, texture;                   // "" for the frame and for every texture
  Verdict verdict = Verdict::same;
  std::optional<double> before, after, limit;
  std::optional<Interval> ratio;  // after over before
  std::string sentence;
};
nlohmann::ordered_json to_json(const VerdictRow& row);

// An A/A arm: the old tree timed against itself, which should show no difference.
struct SameArmRow {
  std::string backend, effect, variant;
  Interval ratio;
  Verdict verdict = Verdict::same;
};
nlohmann::ordered_json to_json(const SameArmRow& row);

struct GateRow {
  std::string mode, against;  // "against" or "baseline"; in words
  Verdict verdict = Verdict::same;
  int status = 0;
  size_t processes = 0, rounds = 0, comparisons = 0;
  double wall_s = 0, margin = 0, confidence = 0;
};
nlohmann::ordered_json to_json(const GateRow& row);

// The gate's verdict, from all rows: failed where any row is slower, worse or failed; ambiguous where any row is, or where
// nothing was compared; faster where a time is faster; else same. `status` is the exit status of the command: 0, 1 or 3.
struct GateOutcome {
  Verdict verdict = Verdict::same;
  int status = 0;
};
GateOutcome outcome_of(std::span<const VerdictRow> rows);

}  // namespace lamina
