// SPDX-License-Identifier: Apache-2.0
#include "harness/measure/timer_certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "harness/core/error.h"
#include "harness/measure/statistics.h"

namespace lamina {
namespace {

constexpr size_t kinds = timer_multiples.size();
static_assert(timer_passes.size() == kinds && timer_multiples[0] == 0);
constexpr int passes_with_work = std::accumulate(timer_passes.begin() + 1, timer_passes.end(), 0);
constexpr int whole =
    std::inner_product(timer_multiples.begin(), timer_multiples.end(), timer_passes.begin(), 0);  // of the work

// What the 1x pass lasts, and how many rounds are run at most. At rest passes of 12 ms tell enough, within two seconds. On a
// machine that is busy with other things a pass waits for slices of time, of some milliseconds each: longer passes and more
// rounds tell its time all the same. Measured beside builds that kept both cores busy, the quartiles of a pass of 45 ms lay 10%
// apart and those of one of 125 ms 4%.
struct Effort {
  double one_ms;
  size_t max_rounds;
};
constexpr std::array<Effort, 3> efforts = {{{12, 30}, {40, 80}, {120, 60}}};
// Greatest share of the 1x pass that is a fixed cost: waking threads takes half a millisecond, up to three on a busy machine. A
// timer that gives every pass the same time has a share of 1.
constexpr double max_fixed_share = 0.25;
// How far the fixed cost may lie from the time of the pass without work, over the 1x pass. A pass with work may have to wait
// for a core that another program holds, a few milliseconds, where one without work ends before.
constexpr double max_wait_share = 0.1;
constexpr double confidence = 0.95;

struct Range {
  double low = 0, high = 0;
  bool empty() const { return low > high; }
  void keep(const Range& other) { low = std::max(low, other.low), high = std::min(high, other.high); }
};

// The share that all passes of a kind have of the time of passes with work, where a pass has a fixed cost, itself such a share:
// from sum(passes * (fixed + per_work * multiple)) = 1.
double per_work_of(double fixed) { return (1 - passes_with_work * fixed) / whole; }
double expected_share(size_t kind, double fixed) {
  return timer_passes[kind] * (fixed + timer_multiples[kind] * per_work_of(fixed));
}
double fixed_share_of(double fixed) {
  const double per_work = per_work_of(fixed);
  return per_work > 0 ? fixed / (fixed + per_work) : 1;
}

// The fixed costs with which the share of a kind is at least and at most these: it is linear in them, and rises or falls.
Range fixed_costs_for(size_t kind, const Range& share) {
  const double at_zero = expected_share(kind, 0), slope = expected_share(kind, 1) - at_zero;
  const double a = (share.low - at_zero) / slope, b = (share.high - at_zero) / slope;
  return {std::min(a, b), std::max(a, b)};
}

// The fixed costs that the passes without work allow.
Range possible_fixed_costs(const Interval& without_work) {
  constexpr double n = timer_passes[0];
  const double middle = without_work.median / n;
  const double wait = max_wait_share * (middle + std::max(0.0, per_work_of(middle)));
  Range range = {std::max(0.0, without_work.low / n - wait), without_work.high / n + wait};
  // fixed <= max_fixed_share * (fixed + per_work_of(fixed)), solved for it.
  const double most = max_fixed_share / whole / (1 - max_fixed_share + max_fixed_share * passes_with_work / whole);
  range.high = std::min(range.high, most);
  return range;
}

double worst_deviation(const std::array<Interval, kinds>& shares, double fixed) {
  double worst = 0;
  for (size_t k = 1; k < kinds; ++k) worst = std::max(worst, std::abs(shares[k].median / expected_share(k, fixed) - 1));
  return worst;
}

// The fixed cost with which the worst kind is nearest to the line. The worst deviation falls, then rises: each kind's does.
double nearest_fixed_cost(const std::array<Interval, kinds>& shares, Range range) {
  for (int step = 0; step < 200; ++step) {
    const double third = (range.high - range.low) / 3;
    if (worst_deviation(shares, range.low + third) <= worst_deviation(shares, range.high - third))
      range.high -= third;
    else
      range.low += third;
  }
  return range.low;
}

// Of a claim that intervals make or do not make; the worst of several is the greatest.
enum class Certainty : uint8_t { holds, open, fails };

Certainty adds_up(const Interval& sum_over_wall) {
  if (sum_over_wall.high < 1 - additivity_tolerance || sum_over_wall.low > 1 + additivity_tolerance) return Certainty::fails;
  const bool certain = sum_over_wall.low >= 1 - certain_tolerance && sum_over_wall.high <= 1 + certain_tolerance;
  return certain ? Certainty::holds : Certainty::open;
}

Certainty is_linear(const std::array<Interval, kinds>& shares, const Range& possible) {
  Range touching = possible;
  bool told = shares[0].coverage >= confidence;  // of as many rounds as all other intervals
  for (size_t k = 1; k < kinds; ++k)
    touching.keep(fixed_costs_for(k, {shares[k].low / (1 + linearity_tolerance), shares[k].high / (1 - linearity_tolerance)}));
  if (touching.empty()) return Certainty::fails;
  Range holding = touching;
  for (size_t k = 1; k < kinds; ++k) {
    // An interval wider than the bounds gives an upside-down range: nothing lies in it.
    const Range certain = {shares[k].high / (1 + certain_tolerance), shares[k].low / (1 - certain_tolerance)};
    told = told && !certain.empty();
    if (told) holding.keep(fixed_costs_for(k, certain));
  }
  return told && !holding.empty() ? Certainty::holds : Certainty::open;
}

std::vector<size_t> passes_in_order() {
  std::vector<size_t> order;
  for (size_t k = 0; k < kinds; ++k) order.insert(order.end(), static_cast<size_t>(timer_passes[k]), k);
  return order;
}

}  // namespace

TimerRow judge_timer(const std::vector<std::vector<double>>& times_ms, const std::vector<double>& wall_ms) {
  if (times_ms.empty() || times_ms.size() != wall_ms.size())
    throw Error(ErrorKind::failed, "timer", "certificate", "no rounds were measured");
  std::vector<double> sums_over_wall, ones_ms;
  std::array<std::vector<double>, kinds> samples;  // of the time of passes with work
  for (size_t round = 0; round < times_ms.size(); ++round) {
    const double working = std::accumulate(times_ms[round].begin() + 1, times_ms[round].end(), 0.0);
    ones_ms.push_back(times_ms[round][1] / timer_passes[1]);
    sums_over_wall.push_back(wall_ms[round] > 0 ? (times_ms[round][0] + working) / wall_ms[round] : 0);
    for (size_t k = 0; k < kinds; ++k) samples[k].push_back(working > 0 ? times_ms[round][k] / working : 0);
  }
  std::array<Interval, kinds> shares;
  for (size_t k = 0; k < kinds; ++k) shares[k] = widest_interval(samples[k], confidence);

  TimerRow row;
  row.one_ms = median(ones_ms);
  const Range possible = possible_fixed_costs(shares[0]);
  const double fixed = possible.empty() ? possible.low : nearest_fixed_cost(shares, possible);
  row.fixed_share = fixed_share_of(fixed);
  row.attribution = 0;
  for (size_t k = 1; k < kinds; ++k) {
    const double expected = expected_share(k, fixed);
    row.linearity.push_back(expected > 0 ? shares[k].median / expected : 0);
    row.attribution = std::max(*row.attribution, std::abs(row.linearity.back() - 1));
  }
  const Interval additivity = widest_interval(sums_over_wall, confidence);
  row.additivity = additivity.median;
  const Certainty linear = possible.empty() ? Certainty::fails : is_linear(shares, possible), added = adds_up(additivity);
  if (linear == Certainty::fails)
    row.reason = "time is not proportional to work";
  else if (added == Certainty::fails)
    row.reason = "the passes' times do not add up to the wall time";
  else if (linear == Certainty::open || added == Certainty::open)
    row.reason = "the machine is too busy to tell whether time is proportional to work";
  row.ok = row.reason.empty();
  return row;
}

TimerCertificate::TimerCertificate(std::unique_ptr<TimedWork> work, TimerRounds so_far)
    : work_(std::move(work)),
      rounds_(std::move(so_far)),
      order_(passes_in_order()),
      random_(7 + rounds_.times_ms.size()) {  // any seed: the orders need only differ
  row_.reason = "too few rounds were measured to tell";
  judge();
}

void TimerCertificate::judge() {
  if (rounds_.times_ms.size() >= min_rounds_for_95) row_ = judge_timer(rounds_.times_ms, rounds_.wall_ms);
}

bool TimerCertificate::is_open() const {
  return !row_.ok && (rounds_.effort + 1 < efforts.size() || rounds_.times_ms.size() < efforts[rounds_.effort].max_rounds);
}

void TimerCertificate::run_round() {
  if (!is_open()) return;
  if (rounds_.times_ms.size() >= efforts[rounds_.effort].max_rounds) rounds_ = {rounds_.effort + 1, {}, {}}, is_set_ = false;
  if (!is_set_) work_->set_duration(efforts[rounds_.effort].one_ms), is_set_ = true;
  std::shuffle(order_.begin(), order_.end(), random_);
  const RunTimes times = work_->run(order_);
  std::vector<double> by_kind(kinds, 0);
  for (size_t i = 0; i < order_.size(); ++i) by_kind[order_[i]] += times.pass_ms.at(i);
  rounds_.times_ms.push_back(std::move(by_kind));
  rounds_.wall_ms.push_back(times.wall_ms);
  judge();
}

}  // namespace lamina
