// SPDX-License-Identifier: Apache-2.0
// How often each basic block of a function runs, from counters in as few of them as can tell.
//
// What comes into a block leaves it, so after `if (a) b else c` the times of b are those of what is before, less those of c.
// Source: Knuth and Stevenson, "Optimal measurement points for program frequency counts", BIT 13 (1973): edges that are not
// asked for are contracted; of the graph that is left, blocks that make a spanning tree need no counter.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lamina {

struct FlowBlock {
  std::vector<uint32_t> next;  // blocks that may follow
  bool asked = false;          // whether its times are wanted
  uint32_t loops = 0;          // that it lies in: counters are put outside of them where they can
};

class BlockFlow {
 public:
  BlockFlow() = default;
  // Block 0 is the function's first; the function ends in a block that nothing follows.
  explicit BlockFlow(std::span<const FlowBlock> blocks);

  // Blocks that need a counter, ascending.
  const std::vector<uint32_t>& counted() const { return counted_; }

  // How often each block that is asked for ran; 0 for others. `calls`: of the function; `counts`: beside counted().
  std::vector<uint64_t> times(uint64_t calls, std::span<const uint64_t> counts) const;

 private:
  // A block leads from what may come before it to what may follow it; both are sets of blocks' ends, numbered.
  struct Edge {
    uint32_t from, to;
  };
  std::vector<Edge> edges_;        // beside the blocks, and at the end the way from the function's end to its beginning
  std::vector<uint32_t> counted_;  // blocks
  std::vector<uint32_t> derived_;  // blocks of the spanning tree
};

}  // namespace lamina
