// SPDX-License-Identifier: Apache-2.0
#include "harness/sweep/points.h"

#include <gtest/gtest.h>

#include <set>

#include "harness/core/error.h"

namespace lamina {
namespace {

std::vector<double> values(const std::string& text) { return parse_swept("a.b=" + text).values; }

TEST(Points, StepsIncludeBothEndsAndKeepDecimals) {
  EXPECT_EQ(values("0:3:1"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(values("0:1:0.1"), (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}));
  EXPECT_EQ(values("0:1:0.4"), (std::vector<double>{0, 0.4, 0.8}));
  EXPECT_EQ(values("2:-2:-2"), (std::vector<double>{2, 0, -2}));
  EXPECT_EQ(values("5:5:1"), (std::vector<double>{5}));
  EXPECT_EQ(values("0:32:1").size(), 33u);
}

TEST(Points, FactorsMultiply) {
  EXPECT_EQ(values("1:64:x2"), (std::vector<double>{1, 2, 4, 8, 16, 32, 64}));
  EXPECT_EQ(values("8:1:x0.5"), (std::vector<double>{8, 4, 2, 1}));
  EXPECT_EQ(values("0.001:1:x10"), (std::vector<double>{0.001, 0.01, 0.1, 1}));
}

TEST(Points, ListsKeepTheirOrder) { EXPECT_EQ(values("3,1,2"), (std::vector<double>{3, 1, 2})); }

TEST(Points, APathMayHoldAnEqualsSign) { EXPECT_EQ(parse_swept("objects.a=b.scale=1,2").path, "objects.a=b.scale"); }

TEST(Points, WhatLeadsNowhereIsRefused) {
  for (const char* bad : {"a.b", "=1", "a.b=", "a.b=1,,2", "a.b=0:1", "a.b=0:1:0", "a.b=0:1:-1", "a.b=0:1:x2", "a.b=1:8:x1",
                          "a.b=1:8:x-2", "a.b=1:8:x0.5", "a.b=1,1", "a.b=nan", "a.b=0:inf:1", "a.b=0:1e9:1", "a.b=0:1:1:1",
                          "a.b=1:1.00000000000005:1e-14", "a.b=1:1.0000000000001:x1.00000000000002"})
    EXPECT_THROW(parse_swept(bad), Error) << bad;
}

// Which words a parameter takes is known only where the parameter is.
TEST(Points, WordsAreKeptAsGiven) {
  EXPECT_EQ(parse_swept("a.b=warm,cold").words, (std::vector<std::string>{"warm", "cold"}));
  EXPECT_TRUE(parse_swept("a.b=warm,cold").values.empty());
  EXPECT_TRUE(parse_swept("a.b=1,2").words.empty());
}

TEST(Points, AGridTurnsTheLastParameterFastest) {
  const SweepPoints grid{{{"a", "", {1, 2}}, {"b", "", {10, 20, 30}}}, false};
  ASSERT_EQ(grid.count(), 6u);
  EXPECT_EQ(grid.at(0), (std::vector<double>{1, 10}));
  EXPECT_EQ(grid.at(1), (std::vector<double>{1, 20}));
  EXPECT_EQ(grid.at(3), (std::vector<double>{2, 10}));
  EXPECT_EQ(grid.at(5), (std::vector<double>{2, 30}));
}

TEST(Points, ZippedValuesGoInPairs) {
  const SweepPoints pairs{{{"a", "", {1, 2}}, {"b", "", {10, 20}}}, true};
  ASSERT_EQ(pairs.count(), 2u);
  EXPECT_EQ(pairs.at(1), (std::vector<double>{2, 20}));
  EXPECT_THROW((SweepPoints{{{"a", "", {1, 2}}, {"b", "", {10}}}, true}.check()), Error);
  EXPECT_THROW((SweepPoints{{{"a", "", {1, 2}}, {"a", "", {3, 4}}}, false}.check()), Error);
}

TEST(Points, ShardsHaveEveryPointOnce) {
  for (const size_t count : {1u, 2u, 5u, 40u}) {
    std::multiset<size_t> had;
    for (size_t index = 0; index < count; ++index)
      for (size_t point = 0; point < 33; ++point)
        if (Shard{index, count}.has(point)) had.insert(point);
    EXPECT_EQ(had.size(), 33u);
    EXPECT_EQ(std::set<size_t>(had.begin(), had.end()).size(), 33u);
  }
  EXPECT_EQ(parse_shard("2/8").index, 1u);
  EXPECT_EQ(parse_shard("2/8").count, 8u);
  for (const char* bad : {"0/2", "3/2", "1", "1/2/3", "a/b", "1/", "/2", "-1/2"}) EXPECT_THROW(parse_shard(bad), Error) << bad;
}

TEST(Points, SchedulesCountFromTheFirstPoint) {
  const Schedule every = parse_schedule("--time", "every:8");
  std::vector<size_t> had;
  for (size_t point = 0; point < 33; ++point)
    if (every.has(point)) had.push_back(point);
  EXPECT_EQ(had, (std::vector<size_t>{0, 8, 16, 24, 32}));
  EXPECT_FALSE(parse_schedule("--time", "none").has(0));
  EXPECT_TRUE(parse_schedule("--time", "all").has(7));
  for (const char* bad : {"every:0", "every", "some", "every:-1", ""})
    EXPECT_THROW(parse_schedule("--time", bad), Error) << bad;
}

}  // namespace
}  // namespace lamina
