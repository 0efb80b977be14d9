// SPDX-License-Identifier: Apache-2.0
// Lines of the record about a gate: its answer, which comes last, so that a gate that died has none; an arm measured against
// itself; what a figure of a cell came to; and the samples that verdicts on times are made of.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/measure/ratio_estimate.h"
#include "harness/measure/statistics.h"

namespace lamina {

enum class Verdict : uint8_t {
  same,
  faster,        // a time, beyond the margin
  better,        // anything else that improved
  not_compared,  // there is nothing to compare with: neither a pass nor a failure
  time_open,     // the same of a time, where every count is equal or fewer and the picture holds: no failure
  ambiguous,     // the interval reaches over the margin
  slower,
  worse,
  failed,  // a limit of its own, or a cell that cannot be measured
};
std::string_view name_of(Verdict verdict);

// Why a verdict is what it is. What each puts into `details` stands behind it.
enum class Cause : uint8_t {
  figures,         // before, after and limit, or the ratio and its margin
  against_record,  // the same of times of another day
  as_before,       // the number of views
  same_code,
  same_code_new_errors,  // what errors are against has changed
  new_variant,
  new_view,
  failed_before,
  gone,
  cannot_be_measured,  // why
  cannot_be_run,       // why
  not_measured,
  process_failed,  // why
  api_message,     // the API's checker's
  certificate_holds,
  certificate_failed,  // why
  error_lost,          // "baseline" or "truth"
  beyond_bound,        // of the gate file
  not_counted,         // what the gate file bounds
  counted_once,        // which state counted no operations: "before" or "after"
  not_finite,
  covers_nothing,  // the pixels that it covered before
  covers_nothing_anywhere,
  one_colour,
  another_hash,
  baseline_changed,
  changed_for_nothing,  // no error got better
  one_picture,          // two views
  too_few_samples,      // whose: "before" or "after"; how many; how many are needed
  ratio_of_zero,
  timed_once,       // which has times: "before" or "after"
  another_machine,  // what differs
  exact_failed,     // so nothing was timed
  out_of_time,      // the budget, s; how long two processes that time would take, s
  stopped,
  arm_differs,  // the verdict on the figures: the A/A arm differs from itself, so no time is believed
};

// Executions of one class of operations, of a pass.
struct OperationChange {
  std::string operation;
  double before = 0, after = 0;
};

struct VerdictRow {
  std::string backend, effect, variant, view;  // view: "" for all of them
  std::string what;                            // "time", "fetches", "ssim", ...
  std::string pass, texture;                   // "" for the frame and for every texture
  Verdict verdict = Verdict::same;
  std::optional<double> before, after, limit;  // what is infinite, as the PSNR of equal pictures, becomes null in the record
  std::optional<Interval> ratio;               // after over before
  std::optional<Cause> cause;                  // none in records of before there were causes
  std::vector<std::string> details;            // see Cause
  std::vector<OperationChange> operations;     // those that changed, where `what` is operations of a pass
  std::optional<bool> counts_hold;             // true of a time whose variant has every count equal or fewer, and its pictures
  std::string sentence;                        // of a record, for its readers: made of the rest by reports/gate/sentences.h
};

// An A/A arm: the old tree timed against itself, which should show no difference.
struct SameArmRow {
  std::string backend, effect, variant;
  Interval ratio;
  Verdict verdict = Verdict::same;  // same, faster, slower or ambiguous
};

struct GateRow {
  std::string mode, against;        // "against" or "baseline"; in words
  Verdict verdict = Verdict::same;  // same, faster, slower, ambiguous or failed
  int status = 0;                   // of the command: 0 to 4
  size_t processes = 0, rounds = 0, comparisons = 0;
  double wall_s = 0, margin = 0, confidence = 0;
};

// What a frame of a pair is.
inline constexpr std::string_view frame_before = "before", frame_after = "after", frame_again = "again";

struct PairedPass {
  std::string name;
  bool cut = false;  // else every round takes all of it
  // [frame]: whether the pass is known to be the same as frame 0's; it is then not run for that frame. Where it is the same in
  // all other frames, frame 0 runs it in the first whole frame only, to find its share of the frame.
  std::vector<bool> same;
  // [frame][round]: the sum over the strips of this round; empty for a frame that has no such pass.
  std::vector<std::vector<double>> ms;
  // [frame]: its strips in all rounds, beside those of frame 0; empty for frame 0, and where either has no such pass.
  std::vector<std::vector<StripPair>> strips;
};

// Times of paired frames of one process.
struct PairsRow {
  size_t process = 0;
  std::string backend, effect, variant, view;
  std::vector<std::string> frames;  // "before", "after", "again" (before a second time), as there are
  std::vector<PairedPass> passes;   // each with as many of everything as there are frames
};

// One line of the record each; times of strips to the nanosecond. Throws Error(failed) for a number that is not finite.
nlohmann::ordered_json to_json(const VerdictRow& row);
nlohmann::ordered_json to_json(const SameArmRow& row);
nlohmann::ordered_json to_json(const GateRow& row);
nlohmann::ordered_json to_json(const PairsRow& row);

}  // namespace lamina
