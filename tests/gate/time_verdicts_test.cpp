// SPDX-License-Identifier: Apache-2.0
// Verdicts on made-up ratios whose answers follow from the definitions, and their error rates on noise with a fixed seed.
#include "harness/gate/time_verdicts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "harness/core/error.h"

namespace lamina {
namespace {

TimeComparison constant(double ratio, size_t processes = 3, size_t rounds = 20, double margin = 0.02) {
  return {std::vector<std::vector<double>>(processes, std::vector<double>(rounds, ratio)), margin};
}
Verdict verdict_of(const TimeComparison& comparison) { return judge_times(std::vector{comparison}, 0.05)[0].verdict; }

TEST(TimeVerdicts, ConstantRatiosFallWhereTheyLie) {
  EXPECT_EQ(verdict_of(constant(1)), Verdict::same);
  EXPECT_EQ(verdict_of(constant(1.019)), Verdict::same);
  EXPECT_EQ(verdict_of(constant(1.021)), Verdict::slower);
  EXPECT_EQ(verdict_of(constant(1 / 1.019)), Verdict::same);
  EXPECT_EQ(verdict_of(constant(1 / 1.021)), Verdict::faster);
}

// An interval of the median from n samples reaches the confidence 1 - 2 / 2^n at most: 5 give 0.9375, 6 give 0.969.
TEST(TimeVerdicts, FiveRoundsDecideNothingAtFivePercentAndSixDo) {
  EXPECT_EQ(verdict_of(constant(1.5, 1, 5)), Verdict::ambiguous);
  EXPECT_EQ(verdict_of(constant(1.5, 1, 6)), Verdict::slower);
}

// Holm: of m comparisons the strongest is held to the error over m. Ten rounds can claim at 2 / 2^10 = 0.00195: enough alone
// and for 25 comparisons (0.002), not for 26.
TEST(TimeVerdicts, ManyComparisonsAskForMoreRounds) {
  for (const size_t many : {size_t{25}, size_t{26}}) {
    const std::vector<TimeComparison> comparisons(many, constant(1.1, 1, 10));
    for (const TimeVerdict& verdict : judge_times(comparisons, 0.05))
      EXPECT_EQ(verdict.verdict, many == 25 ? Verdict::slower : Verdict::ambiguous) << many;
  }
}

// Step down: one strong claim leaves the weaker one the error over m - 1. Six rounds claim at 0.03125, which 0.05 allows to the
// last of two and not to the first.
TEST(TimeVerdicts, AWeakClaimPassesBehindAStrongOne) {
  const std::vector<TimeComparison> weak_alone = {constant(1.1, 1, 6), constant(1.1, 1, 6)};
  for (const TimeVerdict& verdict : judge_times(weak_alone, 0.05)) EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
  const std::vector<TimeComparison> behind = {constant(1.1, 1, 6), constant(1.1, 1, 12)};
  for (const TimeVerdict& verdict : judge_times(behind, 0.05)) EXPECT_EQ(verdict.verdict, Verdict::slower);
}

TEST(TimeVerdicts, AnIntervalOverTheMarginIsAmbiguous) {
  TimeComparison wide{{{}}, 0.02};
  for (int i = 0; i < 40; ++i) wide.ratios[0].push_back(i % 2 == 0 ? 0.9 : 1.1);
  EXPECT_EQ(verdict_of(wide), Verdict::ambiguous);
}

// Processes that do not agree decide nothing, however many rounds each has.
TEST(TimeVerdicts, EveryProcessMustAgree) {
  TimeComparison split = constant(1.05, 3, 200);
  split.ratios[1].assign(10, 1.0);
  EXPECT_EQ(verdict_of(split), Verdict::ambiguous);
  split.ratios[1].assign(10, 1.05);
  EXPECT_EQ(verdict_of(split), Verdict::slower);
}

TEST(TimeVerdicts, TheIntervalHoldsTheMedianAndIsAsWideAsTheConfidenceAsks) {
  TimeComparison comparison{{{}}, 0.02};
  for (int i = 0; i < 100; ++i) comparison.ratios[0].push_back(1 + i * 0.001);
  const std::vector<TimeComparison> alone = {comparison}, among(20, comparison);
  const Interval one = judge_times(alone, 0.05)[0].ratio, many = judge_times(among, 0.05)[0].ratio;
  EXPECT_DOUBLE_EQ(one.median, 1.0495);
  EXPECT_GE(one.coverage, 0.95);
  EXPECT_GT(many.high - many.low, one.high - one.low);
}

TEST(TimeVerdicts, WhatIsNoMeasurementThrows) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    TimeComparison comparison = constant(1);
    comparison.ratios[2][3] = bad;
    EXPECT_THROW(verdict_of(comparison), Error) << bad;
  }
  EXPECT_THROW(verdict_of({{{}, {}}, 0.02}), Error) << "no rounds";
}

// Noise of 5% a round, no difference: the family-wise rate of slower or faster is at most what is asked for. 12 comparisons,
// 400 gates; with the margin in the way it is far below.
TEST(TimeVerdicts, FalseAlarmsOnNoiseStayBelowTheErrorAskedFor) {
  std::mt19937_64 random(1);
  std::lognormal_distribution<double> noise(0, 0.05);
  size_t alarms = 0;
  for (int gate = 0; gate < 400; ++gate) {
    std::vector<TimeComparison> comparisons(12, TimeComparison{std::vector<std::vector<double>>(3), 1e-9});
    for (TimeComparison& comparison : comparisons)
      for (std::vector<double>& process : comparison.ratios)
        for (int round = 0; round < 12; ++round) process.push_back(noise(random));
    bool alarm = false;
    for (const TimeVerdict& verdict : judge_times(comparisons, 0.05))
      alarm = alarm || verdict.verdict == Verdict::slower || verdict.verdict == Verdict::faster;
    alarms += alarm;
  }
  EXPECT_LE(alarms, 400 * 5 / 100) << "with no margin at all";
}

TEST(TimeVerdicts, ADifferenceTwiceTheMarginIsFoundInNoise) {
  std::mt19937_64 random(2);
  std::lognormal_distribution<double> noise(std::log(1.03), 0.02);
  size_t found = 0;
  for (int gate = 0; gate < 200; ++gate) {
    TimeComparison comparison{std::vector<std::vector<double>>(3), 0.015};
    for (std::vector<double>& process : comparison.ratios)
      for (int round = 0; round < 40; ++round) process.push_back(noise(random));
    found += verdict_of(comparison) == Verdict::slower;
  }
  EXPECT_GE(found, 190u);
}

TEST(TimeVerdicts, PrecisionIsTheWidestHalfIntervalInMargins) {
  TimeComparison comparison{{{}}, 0.02};
  for (int i = 0; i < 7; ++i) comparison.ratios[0].push_back(1 + 0.01 * i);  // the 95% interval of 7 is from end to end: 0.06
  const std::vector<TimeComparison> one = {comparison};
  EXPECT_NEAR(worst_precision(one, judge_times(one, 0.05)), 0.03 / 0.02, 1e-9);
}

}  // namespace
}  // namespace lamina
