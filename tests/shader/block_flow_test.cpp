// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/block_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace lamina {
namespace {

// Blocks that are all asked for, with what may follow each.
std::vector<FlowBlock> asked(std::vector<std::vector<uint32_t>> next) {
  std::vector<FlowBlock> blocks;
  for (std::vector<uint32_t>& of_block : next) blocks.push_back({std::move(of_block), true, 0});
  return blocks;
}

TEST(BlockFlow, WhatRunsOnceACallNeedsNoCounter) {
  const BlockFlow flow(asked({{1}, {2}, {}}));
  EXPECT_TRUE(flow.counted().empty());
  EXPECT_EQ(flow.times(7, {}), (std::vector<uint64_t>{7, 7, 7}));
}

TEST(BlockFlow, OneOfTwoBranchesTellsOfTheOther) {
  const BlockFlow flow(asked({{1, 2}, {3}, {3}, {}}));
  ASSERT_EQ(flow.counted().size(), 1u);
  const uint64_t counts[] = {3};
  const std::vector<uint64_t> times = flow.times(10, counts);
  EXPECT_EQ(times[flow.counted()[0]], 3u);
  EXPECT_EQ(times[1] + times[2], 10u);
  EXPECT_EQ(times[3], 10u);
}

TEST(BlockFlow, ALoopNeedsOneCounterOutsideItWhereThatTells) {
  // 1 is the loop's head; 2 its body; a branch inside of it ends the call in 4.
  std::vector<FlowBlock> blocks = asked({{1}, {2, 3}, {1, 4}, {}, {}});
  blocks[1].loops = blocks[2].loops = 1;
  const BlockFlow flow(blocks);
  EXPECT_EQ(flow.counted().size(), 2u);
  EXPECT_EQ(std::ranges::count_if(flow.counted(), [](uint32_t block) { return block == 1 || block == 2; }), 1);
}

TEST(BlockFlow, WhatNobodyAsksForCostsNothing) {
  std::vector<FlowBlock> blocks = asked({{1, 2}, {3}, {3}, {}});
  blocks[1].asked = blocks[2].asked = false;
  EXPECT_TRUE(BlockFlow(blocks).counted().empty());
}

// Random graphs, walked at random: the counted blocks tell how often every other one ran.
TEST(BlockFlow, CountersTellOfEveryBlockOfAnyGraph) {
  std::mt19937 random(3);
  const auto below = [&](size_t n) { return static_cast<uint32_t>(std::uniform_int_distribution<size_t>(0, n - 1)(random)); };
  size_t counted = 0, all = 0;
  for (int graph = 0; graph < 400; ++graph) {
    const uint32_t n = 2 + below(20);
    std::vector<FlowBlock> blocks(n);
    for (uint32_t block = 0; block + 1 < n; ++block) {
      blocks[block].next.push_back(block + 1);          // so that the end is reached
      for (uint32_t more = below(3); more > 0; --more)  // anywhere but to the first, also twice
        blocks[block].next.push_back(1 + below(n - 1));
      if (below(8) == 0) blocks[block].next.clear();  // a discard
    }
    for (FlowBlock& block : blocks) block.asked = below(4) > 0, block.loops = below(3);
    const BlockFlow flow(blocks);
    std::vector<uint64_t> truth(n);
    constexpr uint64_t calls = 50;
    for (uint64_t call = 0; call < calls; ++call)
      for (uint32_t at = 0;;) {
        ++truth[at];
        if (blocks[at].next.empty()) break;
        at = blocks[at].next[below(blocks[at].next.size())];
      }
    std::vector<uint64_t> counts;
    for (const uint32_t block : flow.counted()) counts.push_back(truth[block]);
    const std::vector<uint64_t> times = flow.times(calls, counts);
    for (uint32_t block = 0; block < n; ++block) {
      if (!blocks[block].asked) continue;
      ASSERT_EQ(times[block], truth[block]) << "graph " << graph << " block " << block;
    }
    counted += flow.counted().size();
    all += n;
  }
  EXPECT_LT(counted, all / 2);
}

}  // namespace
}  // namespace lamina
