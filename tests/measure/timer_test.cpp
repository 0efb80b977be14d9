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

TEST(Timer, GoodTimerIsCertified) {
  const TimerRow row = judge_timer(Times(6, {0, 10, 20, 40, 80}), std::vector<double>(6, 151));
  EXPECT_TRUE(row.ok) << row.reason;
  for (const double linearity : row.linearity) EXPECT_NEAR(linearity, 1, 1e-12);
  EXPECT_NEAR(*row.additivity, 150.0 / 151, 1e-12);
  EXPECT_EQ(row.fixed_share, 0);
  EXPECT_EQ(row.one_ms, 10);
}

// Every pass costs 2 ms beside its work: the pass of 8x work takes .87 of eight times the 1x pass, and no timer lies.
TEST(Timer, AFixedCostOfEachPassIsNoLie) {
  const TimerRow row = judge_timer(Times(6, {2, 12, 22, 42, 82}), std::vector<double>(6, 161));
  EXPECT_TRUE(row.ok) << row.reason;
  for (const double linearity : row.linearity) EXPECT_NEAR(linearity, 1, 1e-12);
  EXPECT_NEAR(*row.fixed_share, 2.0 / 12, 1e-12);
  EXPECT_EQ(judge_timer(Times(6, {5, 15, 25, 45, 85}), std::vector<double>(6, 176)).reason, not_linear)
      << "a third is too much";
}

// Work that grows as its 0.9th power looks like a fixed cost of a fifth; the pass without work says that there is none.
TEST(Timer, ACurveIsNotTakenForAFixedCost) {
  Times times(6, {0});
  double sum = 0;
  for (const double multiple : {1.0, 2.0, 4.0, 8.0}) {
    for (std::vector<double>& round : times) round.push_back(10 * std::pow(multiple, 0.9));
    sum += times[0].back();
  }
  EXPECT_EQ(judge_timer(times, std::vector<double>(6, sum)).reason, not_linear);
}

TEST(Timer, LastTileOnlyIsNotLinear) {
  // GL_TIME_ELAPSED on llvmpipe: about the same few milliseconds, whatever the work.
  EXPECT_EQ(judge_timer(Times(6, {3, 3, 3, 3.5, 3.5}), std::vector<double>(6, 400)).reason, not_linear);
}

// Every pass gets the time of the one before it, in orders that change.
TEST(Timer, TimesAPassLateAreRefused) {
  const std::array<double, 5> of_multiple = {0, 10, 20, 40, 80};
  std::array<size_t, 5> order = {0, 1, 2, 3, 4};
  std::mt19937 random(3);
  Times times;
  for (size_t round = 0; round < 40; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    std::vector<double>& late = times.emplace_back(5);
    for (size_t i = 0; i < 5; ++i) late[order[i]] = of_multiple[order[(i + 4) % 5]];
    if (times.size() >= 6) {
      EXPECT_FALSE(judge_timer(times, std::vector<double>(times.size(), 150)).ok) << times.size() << " rounds";
    }
  }
}

// Timestamps resolve at the end of their scene: the first pass gets all the time but a millisecond.
TEST(Timer, AllTimeToTheFirstPassIsRefused) {
  std::mt19937 random(4);
  Times times;
  for (size_t round = 0; round < 40; ++round) {
    std::vector<double>& taken = times.emplace_back(5, 0.25);
    taken[random() % 5] = 149;
    if (times.size() >= 6) {
      EXPECT_FALSE(judge_timer(times, std::vector<double>(times.size(), 150)).ok) << times.size() << " rounds";
    }
  }
}

// A dispatch that runs while its timestamps are deferred, or a framebuffer of no size: microseconds for hundreds of
// milliseconds.
TEST(Timer, MissingTimeDoesNotAddUp) {
  EXPECT_EQ(judge_timer(Times(6, {0, .02, .04, .08, .16}), std::vector<double>(6, 150)).reason, does_not_add_up);
  EXPECT_EQ(judge_timer(Times(6, {0, 10, 20, 40, 80}), std::vector<double>(6, 170)).reason, does_not_add_up);
}

TEST(Timer, DoubleCountingDoesNotAddUpEither) {
  EXPECT_EQ(judge_timer(Times(6, {0, 10, 20, 40, 80}), std::vector<double>(6, 130)).reason, does_not_add_up);
}

// Rounds that something else disturbs widen the interval; with more rounds they do not matter.
TEST(Timer, DisturbedRoundsWantMoreRounds) {
  Times times(7, {0, 10, 20, 40, 80});
  times[2] = {3, 15, 33, 41, 80};
  std::vector<double> wall(7, 150);
  wall[2] = 180;
  EXPECT_EQ(judge_timer(times, wall).reason, too_busy);
  times.resize(9, {0, 10, 20, 40, 80});
  wall.resize(9, 150);
  EXPECT_TRUE(judge_timer(times, wall).ok);
}

TEST(Timer, FewRoundsTellNothing) {
  EXPECT_EQ(judge_timer(Times(5, {0, 10, 20, 40, 80}), std::vector<double>(5, 150)).reason, too_busy);
}

// With the pass of 8x work longer by a share d, each other pass is 1 / (1 + 8 d / 15) of what its share of all work comes to.
TEST(Timer, ThreePercentIsTheBound) {
  const double d = (1 / (1 - linearity_tolerance) - 1) * 15 / 8;
  const auto certified = [](double last) {
    return judge_timer(Times(6, {0, 10, 20, 40, last}), std::vector<double>(6, 70 + last)).ok;
  };
  EXPECT_TRUE(certified(80 * (1 + 0.99 * d)));
  EXPECT_FALSE(certified(80 * (1 + 1.01 * d)));
}

TEST(Timer, ZerosAreNotCertified) { EXPECT_FALSE(judge_timer(Times(6, {0, 0, 0, 0, 0}), std::vector<double>(6, 0)).ok); }

TEST(Timer, NoRoundsAreAnError) { EXPECT_THROW(judge_timer({}, {}), Error); }

}  // namespace
}  // namespace lamina
