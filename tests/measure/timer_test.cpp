// SPDX-License-Identifier: Apache-2.0
// The certificate's judgement on made-up times: a good timer, and each of the ways in which timers have lied.
#include <gtest/gtest.h>

#include "harness/core/error.h"
#include "harness/measure/timer_certificate.h"

namespace lamina {
namespace {

using Times = std::vector<std::vector<double>>;

TEST(Timer, GoodTimerIsCertified) {
  const TimerRow row = judge_timer(Times(6, {10, 20, 40, 80}), std::vector<double>(6, 151));
  EXPECT_TRUE(row.ok) << row.reason;
  EXPECT_EQ(row.linearity, (std::vector<double>{1, 1, 1, 1}));
  EXPECT_NEAR(*row.additivity, 150.0 / 151, 1e-12);
  EXPECT_NEAR(*row.attribution, 0, 1e-12);
  EXPECT_EQ(row.one_ms, 10);
}

TEST(Timer, LastTileOnlyIsNotLinear) {
  // GL_TIME_ELAPSED on llvmpipe: about the same few milliseconds, whatever the work.
  EXPECT_EQ(judge_timer(Times(6, {3, 3, 3.5, 3.5}), std::vector<double>(6, 400)).reason, "time is not proportional to work");
}

TEST(Timer, TimesAPassLateAreRefused) {
  // Every pass gets the time of the one before it, in orders that change.
  EXPECT_FALSE(judge_timer({{80, 10, 20, 40}, {20, 80, 10, 40}, {40, 20, 80, 10}, {20, 40, 80, 10}}, {150, 150, 150, 150}).ok);
}

TEST(Timer, MissingTimeDoesNotAddUp) {
  EXPECT_EQ(judge_timer(Times(6, {10, 20, 40, 80}), std::vector<double>(6, 170)).reason,
            "the passes' times do not add up to the wall time");
}

TEST(Timer, DoubleCountingDoesNotAddUpEither) {
  EXPECT_FALSE(judge_timer(Times(6, {10, 20, 40, 80}), std::vector<double>(6, 130)).ok);
}

TEST(Timer, AFewDisturbedRoundsDoNotMatter) {
  Times times(7, {10, 20, 40, 80});
  times[2] = {15, 33, 41, 80};
  std::vector<double> wall(7, 150);
  wall[2] = 170;
  EXPECT_TRUE(judge_timer(times, wall).ok);
}

TEST(Timer, FivePercentIsTheBound) {
  EXPECT_TRUE(judge_timer(Times(6, {10, 20, 40, 83.9}), std::vector<double>(6, 153.9)).ok);
  EXPECT_FALSE(judge_timer(Times(6, {10, 20, 40, 84.1}), std::vector<double>(6, 154.1)).ok);
}

TEST(Timer, ZerosAreNotCertified) { EXPECT_FALSE(judge_timer(Times(6, {0, 0, 0, 0}), std::vector<double>(6, 0)).ok); }

TEST(Timer, NoRoundsAreAnError) { EXPECT_THROW(judge_timer({}, {}), Error); }

}  // namespace
}  // namespace lamina
