// SPDX-License-Identifier: Apache-2.0
// Rounds over arms whose times are made up: order, pairing, stopping, failures, progress.
#include "harness/measure/rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>

namespace lamina {
namespace {

FrameTimes frame(std::vector<double> pass_ms) { return {std::move(pass_ms), 0}; }

TEST(Rounds, EveryRoundRunsEveryArmOnceInShuffledOrder) {
  std::vector<size_t> calls;
  std::vector<Arm> arms(4);
  for (size_t i = 0; i < arms.size(); ++i)
    arms[i] = {[&calls, i] {
                 calls.push_back(i);
                 return frame({1, 2});
               },
               0};
  RoundOptions options;
  options.min_rounds = options.max_rounds = 50;
  const RoundsResult result = run_rounds(arms, options);
  ASSERT_EQ(calls.size(), 200u);
  size_t in_order = 0;
  std::vector<size_t> first(4, 0);
  for (size_t round = 0; round < 50; ++round) {
    std::vector<size_t> order(calls.begin() + long(round) * 4, calls.begin() + long(round + 1) * 4);
    in_order += order == std::vector<size_t>{0, 1, 2, 3};
    ++first[order[0]];
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<size_t>{0, 1, 2, 3}));
  }
  EXPECT_LT(in_order, 10u) << "1 in 24 by chance";
  for (const size_t times : first) EXPECT_GT(times, 3u) << "each arm is first in a quarter of the rounds by chance";
  EXPECT_EQ(result.arms[2].pass_ms, (std::vector<std::vector<double>>{std::vector<double>(50, 1), std::vector<double>(50, 2)}));
  EXPECT_EQ(result.arms[2].frame_ms, std::vector<double>(50, 3));
  EXPECT_EQ(result.device_ms, 600);
}

// Progress goes by the budget, or by the fewest rounds where these take longer; the end is never passed.
TEST(Rounds, ThePartDoneIsOfTheBudgetOrOfTheFewestRounds) {
  const RoundOptions options{.min_rounds = 10, .budget_s = 4};
  EXPECT_EQ(part_done(0, 0, options), 0);
  EXPECT_EQ(part_done(1, 0, options), 0.25) << "what a round takes is not known";
  EXPECT_EQ(part_done(1, 0.3, options), 0.25) << "ten rounds fit into the budget";
  EXPECT_EQ(part_done(1, 2, options), 0.05) << "ten rounds take 20 s";
  EXPECT_EQ(part_done(25, 2, options), 1);
  EXPECT_EQ(part_done(-1, 2, options), 0) << "what is beside took all of the time";
}

// Before the first round has ended, its arms' expected times are all that tells how long it will be.
TEST(Rounds, TheFirstRoundIsAsLongAsItsArmsAreExpectedToTake) {
  const auto first_told = [](double expected_ms) {
    std::vector<double> told;
    std::vector<Arm> arms(2, Arm{[] {
                                   const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
                                   while (std::chrono::steady_clock::now() < end) {
                                   }
                                   return frame({1});
                                 },
                                 {},
                                 expected_ms});
    run_rounds(arms, {.min_rounds = 10, .max_rounds = 1, .budget_s = 0.1}, [&](double part) { told.push_back(part); });
    EXPECT_EQ(told.size(), 3u) << "before the round, and after each arm";
    return told.at(1);
  };
  EXPECT_GE(first_told(0), 0.2) << "20 ms of a budget of 100";
  EXPECT_LT(first_told(1e6), 1e-3) << "ten rounds of 2000 s";
}

TEST(Rounds, SameSeedSameOrder) {
  const auto order = [](uint64_t seed) {
    std::vector<size_t> calls;
    std::vector<Arm> arms(5);
    for (size_t i = 0; i < arms.size(); ++i)
      arms[i] = {[&calls, i] {
                   calls.push_back(i);
                   return frame({1});
                 },
                 {}};
    RoundOptions options;
    options.seed = seed;
    options.max_rounds = options.min_rounds = 10;
    run_rounds(arms, options);
    return calls;
  };
  EXPECT_EQ(order(3), order(3));
  EXPECT_NE(order(3), order(4));
}

TEST(Rounds, StopsAtTheLeastNumberWhenRatiosArePrecise) {
  const std::vector<Arm> arms = {{[] { return frame({2}); }, 0}, {[] { return frame({1}); }, 0}};
  RoundOptions options;
  options.budget_s = 1000;
  EXPECT_EQ(run_rounds(arms, options).rounds, options.min_rounds);
}

TEST(Rounds, GoesOnWhileARatioIsVague) {
  int call = 0;
  const std::vector<Arm> arms = {{[] { return frame({2}); }, 0}, {[&call] { return frame({call++ % 2 ? 1.0 : 3.0}); }, 0}};
  RoundOptions options;
  options.budget_s = 1000;
  options.max_rounds = 40;
  EXPECT_EQ(run_rounds(arms, options).rounds, 40u);
}

TEST(Rounds, StopsAtTheBudgetButNotBeforeAnIntervalIsPossible) {
  int call = 0;
  const std::vector<Arm> arms = {{[] { return frame({2}); }, 0}, {[&call] { return frame({call++ % 2 ? 1.0 : 3.0}); }, 0}};
  RoundOptions options;
  options.budget_s = -1;
  options.min_rounds = 1;
  EXPECT_EQ(run_rounds(arms, options).rounds, 6u);
}

TEST(Rounds, WhatIsBesideIsDoneOnceARoundAndIsNoArm) {
  std::string calls;
  const auto arm = [&](char name) {
    return Arm{[&calls, name] {
                 calls += name;
                 return frame({1});
               },
               0};
  };
  RoundOptions options;
  options.min_rounds = options.max_rounds = 60;
  options.beside = [&] { calls += '-'; };
  const RoundsResult result = run_rounds({arm('a'), arm('b')}, options);
  ASSERT_EQ(calls.size(), 180u);
  std::set<std::string> orders;
  for (size_t round = 0; round < 60; ++round) {
    std::string one = calls.substr(3 * round, 3);
    orders.insert(one);
    std::ranges::sort(one);
    EXPECT_EQ(one, "-ab");
  }
  EXPECT_EQ(orders.size(), 6u) << "all orders";
  EXPECT_EQ(result.arms.size(), 2u);
  EXPECT_EQ(result.device_ms, 120);
}

TEST(Rounds, AnArmThatFailsIsLeftOutAndTheOthersGoOn) {
  int call = 0;
  const std::vector<Arm> arms = {{[] { return frame({2}); }, 0},
                                 {[&call]() -> FrameTimes {
                                    if (++call == 3) throw Error(ErrorKind::failed, "test", "arm", "lost");
                                    return frame({1});
                                  },
                                  0}};
  const RoundsResult result = run_rounds(arms, {});
  EXPECT_EQ(call, 3);
  EXPECT_TRUE(result.arms[1].frame_ms.empty());
  EXPECT_EQ(result.arms[1].failure, "test: arm: lost");
  EXPECT_EQ(result.arms[0].frame_ms.size(), result.rounds);
}

}  // namespace
}  // namespace lamina
