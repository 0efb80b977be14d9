// SPDX-License-Identifier: Apache-2.0
// What each basic block of a shader does when it runs once: texture operations by texture, operations by class, and both by the
// line of source that says them. From how often few of the blocks ran comes what the shader did (block_flow.h). The levels
// that textures are read at are part of it where they can be told without running it (level_reads.h); the others are counted.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "harness/shader/block_flow.h"
#include "harness/shader/level_reads.h"
#include "harness/shader/operations.h"

namespace lamina {

struct SourceLine {
  std::string file;  // as it was compiled
  uint32_t line = 0;
  auto operator<=>(const SourceLine&) const = default;
};
struct LineWork {
  uint64_t fetches = 0, operations = 0;
  void add(const LineWork& other, uint64_t times = 1) {
    fetches += times * other.fetches;
    operations += times * other.operations;
  }
};
struct ShaderWork {
  std::map<uint32_t, uint64_t> fetches;     // by the texture's binding (arrays: all elements together)
  std::map<uint32_t, uint64_t> unfiltered;  // of those, fetches of single texels
  // How often each level was read, by binding; none of a texture with a read whose level cannot be counted.
  std::map<uint32_t, std::vector<uint64_t>> levels;
  Operations operations;
  std::map<SourceLine, LineWork> lines;
  void add(const ShaderWork& other, uint64_t times);
};

class BlockWork {
 public:
  BlockWork() = default;
  // All functions are inlined into main, or each block has a counter. Throws Error(failed) where a texture cannot be told.
  // `textures`: by binding; of others no levels are told.
  BlockWork(const SpirvModule& module, Stage stage, const LeveledTextures& textures = {});

  // The labels of the blocks that need a counter. main's first never does: it runs once an invocation.
  std::vector<uint32_t> counted_labels() const;
  // The textures with reads whose level is told by running, by binding, and how many levels they have: each level has a
  // counter, behind those of the labels, in this order.
  const std::map<uint32_t, uint32_t>& counted_levels() const { return counted_levels_; }
  // Of both kinds.
  size_t counters() const;
  // What the shader did; `counts`: of the counters. Textures that it has and did not read have 0.
  ShaderWork executed(uint64_t invocations, std::span<const uint64_t> counts) const;
  // What a machine issues that runs all that stands in a branch, taken or not, with the lanes that did not take it masked, and
  // goes through every loop at least once: each block as often as the code around it, as far out as the loop that it lies in.
  // Lanes that go on while others of their group have left a loop are not in it. No lines. Equal to executed() where a function
  // cannot be inlined.
  ShaderWork issued(uint64_t invocations, std::span<const uint64_t> counts) const;

 private:
  BlockFlow flow_;
  std::vector<uint32_t> labels_;  // by block
  std::vector<ShaderWork> work_;  // by block
  // A branch or a loop that is open: the label behind it, its first block, and the block before it.
  struct Construct {
    bool loop;
    uint32_t merge, header, before;
  };
  // The block that is issued as often as another: the header of the outermost branch around it within its loop, or itself; none
  // outside of loops, where a block is issued once an invocation. `around`: the block before the loop.
  struct Issue {
    std::optional<uint32_t> by;
    uint32_t around = 0;
  };
  static Issue issue_of(uint32_t block, std::span<const Construct> open);
  void add_fetch(ShaderWork& of_block, const SpirvModule& module, const SpirvInstruction& operation, Stage stage,
                 const LeveledTextures& textures);
  std::vector<Issue> issues_;  // by block
  std::map<uint32_t, uint32_t> counted_levels_;
  std::set<uint32_t> without_levels_;  // bindings of textures with a read whose level is not known
};

}  // namespace lamina
