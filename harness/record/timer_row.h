// SPDX-License-Identifier: Apache-2.0
// Lines of the record about a timer: its certificate.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

struct TimerRow {
  std::string backend;
  bool ok = false;
  // Time of 1x, 2x, 4x, 8x work over what a fixed cost and its share of all work come to: 1 is perfect.
  std::vector<double> linearity;
  // Absent in a certificate that never got to measure.
  std::optional<double> one_ms{};       // what the pass of 1x work lasted
  std::optional<double> fixed_share{};  // what a pass without work lasts, over that; absent in records of before
  std::optional<double> additivity{};   // sum of passes over the wall time
  // Greatest relative error of a pass's time, the passes' order shuffled every round. A time given to the wrong pass breaks
  // linearity, so this one is reported, not judged.
  std::optional<double> attribution{};
  std::optional<double> age_s{};  // since it was measured, where it was kept from an earlier run
  std::string reason{};           // why not ok
};

// Of the timer that timed the variants of a function: a record of frames has one of its own for them.
struct FunctionTimerRow {
  TimerRow timer;
  std::string function;
};

nlohmann::ordered_json to_json(const TimerRow& row);
nlohmann::ordered_json to_json(const FunctionTimerRow& row);

}  // namespace lamina
