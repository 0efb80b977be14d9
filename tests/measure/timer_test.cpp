// SPDX-License-Identifier: Apache-2.0
// The certificate's judgement on made-up times: a good timer, and each of the ways in which timers have lied.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "harness/core/error.h"
#include "harness/measure/timer_certificate.h"

namespace lamina {
namespace {

using Times = std::vector<std::vector<double>>;

constexpr const char* not_linear = "time is not proportional to work";
constexpr const char* does_not_add_up = "the passes' times do not add up to the wall time";
constexpr const char* too_busy = "the machine is too busy to tell whether time is proportional to work";

// The times of all passes of each kind, where one pass of it lasts as long as `one` says.
std::vector<double> of_all(std::vector<double> one) {
  for (size_t k = 0; k < one.size(); ++k) one[k] *= timer_passes[k];
  return one;
}
const std::vector<double> good = of_all({0, 10, 20, 40, 80});  // 200 ms in all

TEST(Timer, GoodTimerIsCertified) {
  const TimerRow row = judge_timer(Times(6, good), std::vector<double>(6, 201));
  EXPECT_TRUE(row.ok) << row.reason;
  EXPECT_FALSE(row.linearity.empty());
  for (const double linearity : row.linearity) EXPECT_NEAR(linearity, 1, 1e-12);
  EXPECT_NEAR(*row.additivity, 200.0 / 201, 1e-12);
  EXPECT_NEAR(*row.fixed_share, 0, 1e-12);
  EXPECT_EQ(row.one_ms, 10);
}

// Every pass costs 2 ms beside its work: the pass of 8x work takes .87 of eight times the 1x pass, and no timer lies.
TEST(Timer, AFixedCostOfEachPassIsNoLie) {
  const TimerRow row = judge_timer(Times(6, of_all({2, 12, 22, 42, 82})), std::vector<double>(6, 219));
  EXPECT_TRUE(row.ok) << row.reason;
  EXPECT_FALSE(row.linearity.empty());
  for (const double linearity : row.linearity) EXPECT_NEAR(linearity, 1, 1e-12);
  EXPECT_NEAR(*row.fixed_share, 2.0 / 12, 1e-12);
  EXPECT_EQ(judge_timer(Times(6, of_all({5, 15, 25, 45, 85})), std::vector<double>(6, 246)).reason, not_linear)
      << "a third is too much";
}

// On a busy machine each pass with work waits for a core besides, which one without work does not: 1 ms of 11, and no timer
// lies. Where the wait is a fifth of the 1x pass, longer passes have to tell.
TEST(Timer, AWaitForACoreIsNoLie) {
  const auto waiting = [](double ms) {
    return judge_timer(Times(6, of_all({0.1, 10 + ms, 20 + ms, 40 + ms, 80 + ms})), std::vector<double>(6, 200.1 + 8 * ms));
  };
  EXPECT_TRUE(waiting(1).ok) << waiting(1).reason;
  for (const double linearity : waiting(1).linearity) EXPECT_NEAR(linearity, 1, 1e-12);
  EXPECT_NEAR(*waiting(1).fixed_share, 1.0 / 11, 1e-12);
  EXPECT_FALSE(waiting(3).ok);
}

// Work that grows as its 0.9th power looks like a fixed cost of a fifth; the pass without work says that there is none.
TEST(Timer, ACurveIsNotTakenForAFixedCost) {
  Times times(6, {0});
  double sum = 0;
  for (size_t k = 1; k < timer_passes.size(); ++k) {
    for (std::vector<double>& round : times) round.push_back(timer_passes[k] * 10 * std::pow(std::pow(2, k - 1), 0.9));
    sum += times[0].back();
  }
  EXPECT_EQ(judge_timer(times, std::vector<double>(6, sum)).reason, not_linear);
}

TEST(Timer, LastTileOnlyIsNotLinear) {
  // GL_TIME_ELAPSED on llvmpipe: about the same few milliseconds, whatever the work.
  EXPECT_EQ(judge_timer(Times(6, of_all({3, 3, 3, 3.5, 3.5})), std::vector<double>(6, 400)).reason, not_linear);
}

// Every pass gets the time of the one before it, in orders that change.
TEST(Timer, TimesAPassLateAreRefused) {
  const std::array<double, 5> of_multiple = {0, 10, 20, 40, 80};
  std::vector<size_t> order = {0, 1, 1, 1, 1, 2, 2, 3, 4};
  std::mt19937 random(3);
  Times times;
  for (size_t round = 0; round < 40; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    std::vector<double>& late = times.emplace_back(5);
    for (size_t i = 0; i < order.size(); ++i) late[order[i]] += of_multiple[order[(i + order.size() - 1) % order.size()]];
    if (times.size() >= 6) {
      EXPECT_FALSE(judge_timer(times, std::vector<double>(times.size(), 200)).ok) << times.size() << " rounds";
    }
  }
}

// Timestamps resolve at the end of their scene: the first pass gets all the time but a millisecond.
TEST(Timer, AllTimeToTheFirstPassIsRefused) {
  std::mt19937 random(4);
  Times times;
  for (size_t round = 0; round < 40; ++round) {
    std::vector<double>& taken = times.emplace_back(of_all(std::vector<double>(5, 0.25)));
    taken[std::array{0, 1, 1, 1, 1, 2, 2, 3, 4}[random() % 9]] += 148;
    if (times.size() >= 6) {
      EXPECT_FALSE(judge_timer(times, std::vector<double>(times.size(), 200)).ok) << times.size() << " rounds";
    }
  }
}

// A dispatch that runs while its timestamps are deferred, or a framebuffer of no size: microseconds for hundreds of
// milliseconds.
TEST(Timer, MissingTimeDoesNotAddUp) {
  EXPECT_EQ(judge_timer(Times(6, of_all({0, .02, .04, .08, .16})), std::vector<double>(6, 200)).reason, does_not_add_up);
  EXPECT_EQ(judge_timer(Times(6, good), std::vector<double>(6, 226)).reason, does_not_add_up);
}

TEST(Timer, DoubleCountingDoesNotAddUpEither) {
  EXPECT_EQ(judge_timer(Times(6, good), std::vector<double>(6, 173)).reason, does_not_add_up);
}

// Rounds that something else disturbs widen the interval; with more rounds they do not matter.
TEST(Timer, DisturbedRoundsWantMoreRounds) {
  Times times(7, good);
  times[2] = of_all({3, 15, 33, 41, 80});
  std::vector<double> wall(7, 200);
  wall[2] = 250;
  EXPECT_EQ(judge_timer(times, wall).reason, too_busy);
  times.resize(9, good);
  wall.resize(9, 200);
  EXPECT_TRUE(judge_timer(times, wall).ok);
}

TEST(Timer, FewRoundsTellNothing) { EXPECT_EQ(judge_timer(Times(5, good), std::vector<double>(5, 200)).reason, too_busy); }

// With the pass of 8x work longer by a share d, its share of all work is (1 + d) / (1 + 0.4 d) of what it should be. No fixed
// cost is below 0, which would explain it.
TEST(Timer, ThreePercentIsTheBound) {
  const double d = linearity_tolerance / (1 - 0.4 * (1 + linearity_tolerance));
  const auto certified = [](double last) {
    return judge_timer(Times(6, of_all({0, 10, 20, 40, last})), std::vector<double>(6, 120 + last)).ok;
  };
  EXPECT_TRUE(certified(80 * (1 + 0.99 * d)));
  EXPECT_FALSE(certified(80 * (1 + 1.01 * d)));
  EXPECT_TRUE(certified(80 * 0.94));
  EXPECT_FALSE(certified(80 * 0.93)) << "with no fixed cost it is too short, with any the pass of 4x work too long";
}

TEST(Timer, ZerosAreNotCertified) { EXPECT_FALSE(judge_timer(Times(6, {0, 0, 0, 0, 0}), std::vector<double>(6, 0)).ok); }

TEST(Timer, NoRoundsAreAnError) { EXPECT_THROW(judge_timer({}, {}), Error); }

}  // namespace
}  // namespace lamina
