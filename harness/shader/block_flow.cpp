// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/block_flow.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>

namespace lamina {

BlockFlow::BlockFlow(std::span<const FlowBlock> blocks) {
  const auto calls = static_cast<uint32_t>(blocks.size());  // the way back, as if a block
  const auto before = [](uint32_t block) { return 2 * block; };
  const auto after = [](uint32_t block) { return 2 * block + 1; };
  boost::disjoint_sets_with_storage<> ends(2 * (blocks.size() + 1));
  const auto join = [&](uint32_t a, uint32_t b) { ends.union_set(ends.find_set(a), ends.find_set(b)); };
  for (uint32_t block = 0; block < calls; ++block) {
    for (const uint32_t next : blocks[block].next) join(after(block), before(next));
    if (blocks[block].next.empty()) join(after(block), before(calls));
    if (!blocks[block].asked) join(before(block), after(block));
  }
  join(after(calls), before(0));

  for (uint32_t block = 0; block <= calls; ++block)
    edges_.push_back({static_cast<uint32_t>(ends.find_set(before(block))), static_cast<uint32_t>(ends.find_set(after(block)))});

  std::vector<uint32_t> order;
  for (uint32_t block = 0; block < calls; ++block)
    if (blocks[block].asked) order.push_back(block);
  std::ranges::stable_sort(order, std::greater{}, [&](uint32_t block) { return blocks[block].loops; });
  // The calls are known, so the tree does without them where it can: they come last.
  boost::disjoint_sets_with_storage<> tree(2 * (blocks.size() + 1));
  for (const uint32_t block : order) {
    const auto from = tree.find_set(edges_[block].from), to = tree.find_set(edges_[block].to);
    if (from == to)
      counted_.push_back(block);
    else
      derived_.push_back(block), tree.link(from, to);
  }
  std::ranges::sort(counted_);
}

std::vector<uint64_t> BlockFlow::times(uint64_t calls, std::span<const uint64_t> counts) const {
  std::vector<uint64_t> times(edges_.empty() ? 0 : edges_.size() - 1);
  // What comes into a set of ends less what leaves it, of the edges that are known. Sums may wrap: they end where they began.
  std::map<uint32_t, uint64_t> surplus;
  std::map<uint32_t, std::vector<uint32_t>> unknown;  // by set: blocks of the tree
  const auto know = [&](const Edge& edge, uint64_t count) {
    surplus[edge.to] += count;
    surplus[edge.from] -= count;
  };
  for (size_t i = 0; i < counted_.size(); ++i) know(edges_[counted_[i]], times[counted_[i]] = counts[i]);
  if (!edges_.empty()) know(edges_.back(), calls);
  for (const uint32_t block : derived_) {
    unknown[edges_[block].from].push_back(block);
    unknown[edges_[block].to].push_back(block);
  }
  // From the leaves of the tree: what a set lacks flows through its only edge that is not known.
  std::vector<uint32_t> leaves;
  for (const auto& [set, blocks] : unknown)
    if (blocks.size() == 1) leaves.push_back(set);
  while (!leaves.empty()) {
    const uint32_t set = leaves.back();
    leaves.pop_back();
    if (unknown[set].empty()) continue;  // its last edge was found from the other end
    const uint32_t block = unknown[set].front();
    const Edge& edge = edges_[block];
    times[block] = edge.from == set ? surplus[set] : -surplus[set];
    know(edge, times[block]);
    for (const uint32_t end : {edge.from, edge.to}) {
      std::erase(unknown[end], block);
      if (unknown[end].size() == 1) leaves.push_back(end);
    }
  }
  return times;
}

}  // namespace lamina
