// SPDX-License-Identifier: Apache-2.0
// Verdicts on made-up ratios whose answers follow from the definitions, and their error rates on noise with a fixed seed.
#include "harness/gate/time_verdicts.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>

#include "harness/core/error.h"

namespace lamina {
namespace {

// Each of the processes with this ratio and error.
TimeComparison comparison(double ratio, double error, size_t processes = 3, double margin = 0.02) {
  return {std::vector<RatioEstimate>(processes, {std::log(ratio), error, 200, 198}), margin};
}
Verdict verdict_of(const TimeComparison& comparison, double error = 0.05) {
  return judge_times(std::vector{comparison}, {}, error)[0].verdict;
}

SharedDisagreement shared_by(const std::vector<TimeComparison>& comparisons) {
  std::vector<PooledRatio> pooled;
  for (const TimeComparison& each : comparisons) pooled.push_back(pool(each.processes));
  return shared_disagreement(pooled);
}

TEST(TimeVerdicts, RatiosWithoutErrorFallWhereTheyLie) {
  EXPECT_EQ(verdict_of(comparison(1, 0)), Verdict::same);
  EXPECT_EQ(verdict_of(comparison(1.019, 0)), Verdict::same);
  EXPECT_EQ(verdict_of(comparison(1.021, 0)), Verdict::slower);
  EXPECT_EQ(verdict_of(comparison(1 / 1.019, 0)), Verdict::same);
  EXPECT_EQ(verdict_of(comparison(1 / 1.021, 0)), Verdict::faster);
}

// One process of 200 strips has 198 degrees of freedom: at 5% a ratio must lie 1.972 errors beyond the margin.
TEST(TimeVerdicts, AClaimNeedsAsManyErrorsAsStudentSays) {
  const double reach = boost::math::quantile(boost::math::students_t(198), 0.975), edge = std::log(1.02);
  EXPECT_NEAR(reach, 1.972, 0.001);
  for (const auto& [away, slower] : {std::pair(0.99, false), std::pair(1.01, true)}) {
    const double ratio = std::exp(edge + away * reach * 0.01);
    EXPECT_EQ(verdict_of(comparison(ratio, 0.01, 1)), slower ? Verdict::slower : Verdict::ambiguous) << away;
    EXPECT_EQ(verdict_of(comparison(1 / ratio, 0.01, 1)), slower ? Verdict::faster : Verdict::ambiguous) << away;
  }
  // The same, by both sides: from the middle of the margin as many errors to either edge.
  EXPECT_EQ(verdict_of(comparison(1, edge / reach * 0.99, 1)), Verdict::same);
  EXPECT_EQ(verdict_of(comparison(1, edge / reach * 1.01, 1)), Verdict::ambiguous);
}

// Few strips have heavier tails: what 200 can claim, 5 cannot.
TEST(TimeVerdicts, FewStripsMustBeFurtherAway) {
  TimeComparison few = comparison(1.06, 0.015, 1);
  EXPECT_EQ(verdict_of(few), Verdict::slower);
  few.processes[0].freedom = 3;
  EXPECT_EQ(verdict_of(few), Verdict::ambiguous);
}

// Holm: of m comparisons the strongest is held to the error over m, the next to that over m - 1.
TEST(TimeVerdicts, ManyComparisonsAskForMore) {
  const double edge = std::log(1.02);
  const auto at = [&](double chance) {  // a ratio whose claim has this chance, both sides together
    const double reach = boost::math::quantile(boost::math::students_t(198), 1 - chance / 2);
    return comparison(std::exp(edge + reach * 0.01), 0.01, 1);
  };
  for (const auto& [chance, found] : {std::pair(0.0048, true), std::pair(0.0052, false)})
    for (const TimeVerdict& verdict : judge_times(std::vector<TimeComparison>(10, at(chance)), {}, 0.05))
      EXPECT_EQ(verdict.verdict, found ? Verdict::slower : Verdict::ambiguous) << chance;
  // 0.04 is too weak as the first of two and strong enough as the last.
  for (const TimeVerdict& verdict : judge_times(std::vector{at(0.04), at(0.04)}, {}, 0.05))
    EXPECT_EQ(verdict.verdict, Verdict::ambiguous);
  for (const TimeVerdict& verdict : judge_times(std::vector{at(0.04), at(0.001)}, {}, 0.05))
    EXPECT_EQ(verdict.verdict, Verdict::slower);
}

// Processes that do not agree decide nothing, however sure each is.
TEST(TimeVerdicts, ProcessesMustAgree) {
  TimeComparison split = comparison(1.05, 0.001);
  EXPECT_EQ(verdict_of(split), Verdict::slower);
  split.processes[1].log_ratio = 0;
  EXPECT_EQ(verdict_of(split), Verdict::ambiguous);
}

TEST(TimeVerdicts, TheIntervalIsAsWideAsTheConfidenceAsks) {
  const std::vector<TimeComparison> alone = {comparison(1.05, 0.01, 1)}, among(20, comparison(1.05, 0.01, 1));
  const Interval one = judge_times(alone, {}, 0.05)[0].ratio, many = judge_times(among, {}, 0.05)[0].ratio;
  EXPECT_NEAR(one.median, 1.05, 1e-12);
  EXPECT_NEAR(one.low, 1.05 * std::exp(-0.01972), 1e-5);
  EXPECT_NEAR(one.high, 1.05 * std::exp(0.01972), 1e-5);
  EXPECT_EQ(one.rounds, 200u);
  EXPECT_NEAR(one.coverage, 0.95, 1e-12);
  EXPECT_NEAR(many.coverage, 1 - 0.05 / 20, 1e-12) << "the first of twenty";
  EXPECT_GT(many.high - many.low, one.high - one.low);
}

TEST(TimeVerdicts, WhatIsNoMeasurementThrows) {
  TimeComparison bad = comparison(1, 0.01);
  bad.processes[2].log_ratio = std::nan("");
  EXPECT_THROW(verdict_of(bad), Error);
  EXPECT_THROW(verdict_of({{}, 0.02}), Error) << "no processes";
}

// Estimates that scatter by their errors, no difference and hardly a margin: the family-wise rate of slower or faster is at
// most what is asked for. 12 comparisons, 2000 gates.
TEST(TimeVerdicts, FalseAlarmsOnNoiseStayBelowTheErrorAskedFor) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  int alarms = 0;
  for (int gate = 0; gate < 2000; ++gate) {
    std::vector<TimeComparison> comparisons(12, comparison(1, 0.01, 3, 1e-9));
    for (TimeComparison& each : comparisons)
      for (RatioEstimate& process : each.processes) process.log_ratio = noise(random);
    bool alarm = false;
    for (const TimeVerdict& verdict : judge_times(comparisons, shared_by(comparisons), 0.05))
      alarm = alarm || verdict.verdict == Verdict::slower || verdict.verdict == Verdict::faster;
    alarms += alarm;
  }
  EXPECT_LE(alarms, 2000 * 5 / 100);
  EXPECT_GT(alarms, 0) << "the test can see them";
}

// A machine on which much else runs: processes have few strips, whose spread tells their errors badly, bursts lengthen whole
// processes, and passes differ in how restless they are. Equal code is called slower or faster in no more gates than the
// error asked for.
TEST(TimeVerdicts, ABusyMachineRaisesNoAlarm) {
  std::mt19937_64 random(15);
  std::student_t_distribution<double> bursts(2.5);
  std::chi_squared_distribution<double> of_few(3);
  std::normal_distribution<double> normal;
  int alarms = 0;
  for (int gate = 0; gate < 1000; ++gate) {
    std::vector<TimeComparison> comparisons(12, comparison(1, 0, 8, 0.015));
    for (TimeComparison& each : comparisons) {
      const double restless = 0.05 * std::exp(normal(random));
      for (RatioEstimate& process : each.processes)
        process = {restless * bursts(random), restless * of_few(random) / 3, 4, freedom_of(4)};
    }
    bool alarm = false;
    for (const TimeVerdict& verdict : judge_times(comparisons, shared_by(comparisons), 0.05))
      alarm = alarm || verdict.verdict == Verdict::slower || verdict.verdict == Verdict::faster;
    alarms += alarm;
  }
  EXPECT_LE(alarms, 50);
}

// A short gate over many variants: two processes of four strips each, from which an error is small by luck in some of many
// comparisons. Were errors taken for what they seem, one gate of five would raise an alarm.
TEST(TimeVerdicts, FewStripsInFewProcessesRaiseNoAlarm) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::student_t_distribution<double> bursts(2.5);
  int alarms = 0;
  for (int gate = 0; gate < 200; ++gate) {
    std::vector<TimeComparison> comparisons(84, {{}, 0.015});
    for (TimeComparison& each : comparisons) {
      const double restless = 0.05 * std::exp(0.5 * normal(random));
      for (int process = 0; process < 2; ++process) {
        const double layout = 0.012 * normal(random);
        std::vector<StripPair> strips;
        for (int strip = 0; strip < 4; ++strip)
          strips.push_back({5, 5 * std::exp(layout + restless * bursts(random)), random() % 2 == 0});
        each.processes.push_back(estimate_ratio(strips));
      }
    }
    bool alarm = false;
    for (const TimeVerdict& verdict : judge_times(comparisons, shared_by(comparisons), 0.05))
      alarm = alarm || verdict.verdict == Verdict::slower || verdict.verdict == Verdict::faster;
    alarms += alarm;
  }
  EXPECT_LE(alarms, 200 * 5 / 100);
}

TEST(TimeVerdicts, ADifferenceTwiceTheMarginIsFoundInNoise) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(std::log(1.03), 0.0045);
  int found = 0;
  for (int gate = 0; gate < 500; ++gate) {
    TimeComparison each = comparison(1, 0.0045, 5, 0.015);
    for (RatioEstimate& process : each.processes) process.log_ratio = noise(random);
    found += verdict_of(each) == Verdict::slower;
  }
  EXPECT_GE(found, 490);
}

}  // namespace
}  // namespace lamina
