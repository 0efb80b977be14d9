// SPDX-License-Identifier: Apache-2.0
// How the gates of a calibration ended: as lines of its file, from which it resumes, and as a table of the gate's error rates.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/gate/pairs.h"

namespace lamina {

// One gate. `slow_down`: what its trees were made to differ by, 0.03 is 3%, 0: equal trees. The verdict is same, faster, slower
// or ambiguous. `ratios`: the median ratio of the slowed pass on each backend.
struct CalibratedGate {
  double slow_down = 0;
  Verdict verdict = Verdict::ambiguous;
  std::vector<double> ratios;
};
// Judged as every gate is, by the default limits.
CalibratedGate judge_calibrated(double slow_down, const std::vector<PairsRow>& pairs, double family_error,
                                const std::string& pass);
nlohmann::ordered_json to_json(const CalibratedGate& gate);
CalibratedGate calibrated_from_json(const nlohmann::json& line);

// The lines of a calibration's file, the first of which says what is calibrated; none where there is no file. A last line that
// was cut short is left out. Throws Error(bad_input) for a file that holds anything else.
std::vector<nlohmann::json> read_calibration(const std::filesystem::path& file);

// A Markdown table, a row for each slow-down in ascending order: gates, the share found slower (over equal trees: slower or
// faster, which are false alarms) with its 95% interval, ambiguous, the same, and the mean ratio that was measured.
std::string calibration_table(std::span<const CalibratedGate> gates);

// Wilson's interval of a share (E. B. Wilson, "Probable inference, the law of succession, and statistical inference", Journal
// of the American Statistical Association 22, 1927), 95%. `of` is above 0.
std::pair<double, double> share_interval(size_t hits, size_t of);

}  // namespace lamina
