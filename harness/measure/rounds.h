// SPDX-License-Identifier: Apache-2.0
// Timing by shuffled, interleaved rounds: one round runs every arm once, in random order, so that drift of the machine cancels
// in ratios taken within a round. Stops when every ratio is known precisely enough (not when it is significant, which would
// bias it), or at the budget.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/graph/frame.h"
#include "harness/measure/statistics.h"

namespace lamina {

struct Arm {
  std::function<FrameTimes()> run;  // one timed frame
  std::optional<size_t> baseline;   // the arm that its ratio is taken to
  double expected_ms = 0;           // of a frame, for the progress of the first round; 0: not known
};

struct ArmSamples {
  std::vector<std::vector<double>> pass_ms;  // [pass][round]
  std::vector<double> frame_ms;              // [round], the sum over passes
  std::string failure;                       // of a run that threw: the arm then has no samples
};

struct RoundOptions {
  size_t min_rounds = min_rounds_for_95;  // fewer are not accepted
  size_t max_rounds = 1000;
  double budget_s = 20;          // no round starts later than this
  double precision = 0.01;       // half width of every ratio's 95% interval, relative to its median
  uint64_t seed = 1;             // of the order
  std::function<bool()> stop{};  // asked between rounds: true ends them, however few they are; not asked where empty
  // Work of its own, such as a timer's certificate: done once in each round, somewhere among the arms. Its time is neither of
  // the budget nor of the result's.
  std::function<void()> beside{};
};

struct RoundsResult {
  std::vector<ArmSamples> arms;
  size_t rounds = 0;
  double wall_ms = 0;    // of all rounds, host clock, without what was done beside them
  double device_ms = 0;  // sum of all samples
};

// What part of the rounds is done after `elapsed_s`, 0 to 1, where a round takes `round_s` (0: not known): of what the budget
// holds, or of the fewest that are accepted where these take longer. Rounds may end sooner, where ratios are precise.
double part_done(double elapsed_s, double round_s, const RoundOptions& options);

// `progress` is called before each round and after each arm, with part_done(): of rounds as long as those before, and in the
// first round as long as the arms are expected to take.
RoundsResult run_rounds(const std::vector<Arm>& arms, const RoundOptions& options,
                        const std::function<void(double)>& progress = {});

}  // namespace lamina
