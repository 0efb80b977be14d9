// SPDX-License-Identifier: Apache-2.0
// Code that counts the levels which textures are read at, for the reads that only running tells (level_reads.h): a private
// counter for every level of every such texture, added to before each texture operation.
#pragma once

#include "harness/shader/level_reads.h"
#include "harness/shader/private_counters.h"

namespace lamina {

class LevelCounting {
 public:
  // All must outlive this.
  LevelCounting(SpirvWriter& code, PrivateCounters& counters, Stage stage, const LeveledTextures& textures)
      : code_(code), counters_(counters), stage_(stage), textures_(textures) {}

  // `counted`: how many levels the textures have whose levels are counted, by binding; their counters, in this order, begin at
  // `first`.
  void place(const std::map<uint32_t, uint32_t>& counted, uint32_t first);
  // Counts the levels that a texture operation is about to read, where running tells them; into the writer's body.
  void count(const SpirvInstruction& operation);
  // Whether the code asks the device for levels, and the module has not yet the capability for it (ImageQuery).
  bool needs_query() const;

 private:
  void add(uint32_t binding, uint32_t level, uint32_t amount);
  uint32_t lambda_of(const SpirvInstruction& operation, const LeveledTexture& texture);
  uint32_t texels_of(uint32_t gradient, const LeveledTexture& texture);
  uint32_t coordinates_of(const SpirvInstruction& operation);
  uint32_t vector(uint32_t components);

  SpirvWriter& code_;
  PrivateCounters& counters_;
  const Stage stage_;
  const LeveledTextures& textures_;
  std::map<uint32_t, uint32_t> first_of_;  // by binding: the counter of level 0
  bool asks_ = false;
};

}  // namespace lamina
