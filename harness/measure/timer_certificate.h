// SPDX-License-Identifier: Apache-2.0
// Certifies a timer: passes of known relative work are timed with the same timer that measures variants, and judged. Software
// rasterizers and tile-based devices have reported the last tile's time, or another pass's, for a pass's. No clock is asked
// here: timer_work.h has the passes on a device.
#pragma once

#include <array>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/record/timer_row.h"

namespace lamina {

// The kinds of passes: 0x, 1x, 2x, 4x and 8x work, and how many of each a frame has. What disturbs a pass costs a short one a
// greater share of its time: the short ones run more often, so that each kind is told about as well as another.
inline constexpr std::array<int, 5> timer_multiples = {0, 1, 2, 4, 8};
inline constexpr std::array<int, 5> timer_passes = {1, 4, 2, 1, 1};

// Bounds that a certificate holds to. Of 3%: where the pass of 8x work is 5.1% too long beside the others, its share of all is
// 3% too great.
inline constexpr double linearity_tolerance = 0.03;
inline constexpr double additivity_tolerance = 0.05;
// And what must be certain: on a busy machine intervals are wide, and timers that lied did so by factors.
inline constexpr double certain_tolerance = 0.1;

// The certificate of measured rounds. times_ms[round] are the times of all passes of each kind, as many as timer_passes says;
// wall_ms[round] is the frame's wall time. All figures are medians over rounds of ratios within a round, so a machine whose
// speed drifts from round to round is not taken for a bad timer. The times of passes must lie on a line: a fixed cost of a
// pass, and its share of all work. That cost is about what a pass without work takes; on a busy machine a pass waits for a core
// besides, which counts into it. The certificate holds where, of some such line, all 95% intervals reach within the tolerance
// and lie within certain_tolerance. It fails where they do not reach within the tolerance of any. Between, the machine is too
// busy to tell, which more rounds may mend. Throws Error(failed) where there are no rounds.
TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms);

// Passes of known relative work, each through the timer that is to be certified.
class TimedWork {
 public:
  virtual ~TimedWork() = default;
  // Sets the pass of 1x work to last about so long, and the others by it.
  virtual void set_duration(double one_ms) = 0;
  // One frame: a pass of each of these kinds, in this order.
  virtual RunTimes run(std::span<const size_t> kinds) = 0;
};

// Rounds of a certificate of passes of one length.
struct TimerRounds {
  size_t effort = 0;  // how long its passes are: an index
  std::vector<std::vector<double>> times_ms;
  std::vector<double> wall_ms;
};

// A certificate while it is measured: round by round, so that its rounds can stand between others, and in another process go
// on where an earlier one ended.
class TimerCertificate {
 public:
  explicit TimerCertificate(std::unique_ptr<TimedWork> work, TimerRounds so_far = {});

  // One frame more, in shuffled order; of longer passes where there were rounds enough of shorter ones. Nothing where it is no
  // longer open.
  void run_round();
  bool is_open() const;                         // whether more rounds may tell
  const TimerRow& row() const { return row_; }  // by the rounds so far; its backend is left blank
  const TimerRounds& rounds() const { return rounds_; }

 private:
  void judge();

  std::unique_ptr<TimedWork> work_;
  TimerRounds rounds_;
  bool is_set_ = false;  // the passes' duration
  std::vector<size_t> order_;
  std::mt19937_64 random_;
  TimerRow row_;
};

}  // namespace lamina
