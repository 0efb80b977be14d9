// SPDX-License-Identifier: Apache-2.0
// A gate's lines sorted into the order in which a person reads them, and in words: shared by the reports of
// reports/gate/gate.h. All strings are plain text, not yet escaped for where they go.
#pragma once

#include <string>
#include <vector>

#include "harness/record/record.h"
#include "reports/tables/table.h"

namespace lamina {

struct GateReading {
  using Rows = std::vector<const VerdictRow*>;         // into the record, which must outlive this
  Rows regressed;                                      // slower, worse, failed
  Rows ambiguous, open, not_compared, improved, same;  // open: times that counts need not wait for; improved: faster, better
  std::vector<const SameArmRow*> unequal_aas;          // A/A arms that differ from themselves
  bool well = false;                                   // the gate says so and its figures bear it out
  std::string word;                                    // "passed", "FAILED", "AMBIGUOUS" or "NO VERDICT"
  std::string counts;                                  // "2 of 36 checks regressed, 1 is ambiguous"
  std::string conditions;  // "against main, 60 rounds in 3 processes, 41.2 s, ..."; "" without an answer
  // Why the answer cannot be believed: it is missing, its figures contradict it, nothing was compared. "" for most.
  std::string trouble;
};
GateReading reading_of(const Record& record);
// "gate FAILED: 6 checks: 2 regressed, 4 the same", what is wrong with the answer, its conditions. None where the record is not
// a gate's.
std::vector<std::string> gate_lines(const Record& record);

// Of a verdict line.
std::string place_of(const VerdictRow& row);          // "view front, pass composite, texture light_map"; "" for the whole frame
std::string subject_of(const VerdictRow& row);        // "vertex_normal on vulkan, view front, pass composite", or "vulkan"
std::string before_and_after(const VerdictRow& row);  // "12.31 -> 13.54 ms", "now 0.052", "" where neither is known
std::string change_of(const VerdictRow& row);         // "+10.1% [+8.2%, +11.9%]", "-0.0123"; "" where not known
std::string certainty_of(const VerdictRow& row);      // "95.9% interval, 60 rounds", or "exact"
std::string limit_of(const VerdictRow& row);          // "0.03"; "" where there is none
std::string percent(double ratio);                    // 1.1: "+10.0%"
// What kind of answer it is: "count" and "picture" are exact, "interval" is of measured times, "code" needs no measurement.
std::string_view kind_of(const VerdictRow& row);
// Every verdict, in the order in which they are read: what regressed first, marked as bad, what is the same last.
Table verdicts_table(const GateReading& reading);
// Of an A/A line: "A/A vertex_normal on vulkan: 1.001 [0.997, 1.004], 60 rounds: same".
std::string words_for_aa(const SameArmRow& aa);
inline constexpr const char* aa_note =
    "A/A: the same code timed against itself. Slower or faster here means that the times of this run are not to be believed.";
// "vulkan: llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6", one a device.
std::vector<std::string> device_lines(const Record& record);

}  // namespace lamina
