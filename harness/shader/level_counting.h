// SPDX-License-Identifier: Apache-2.0
// Code that counts the levels which textures are read at, for the reads that only running tells (level_reads.h): a private
// array for every such texture, an element a level, added to before each texture operation.
#pragma once

#include "harness/shader/level_reads.h"
#include "harness/shader/spirv_writer.h"

namespace lamina {

class LevelCounting {
 public:
  // All must outlive this.
  LevelCounting(SpirvWriter& code, Stage stage, const LeveledTextures& textures)
      : code_(code), stage_(stage), textures_(textures) {}

  // The arrays; `counted`: how many levels the textures have whose levels are counted, by binding.
  void declare(const std::map<uint32_t, uint32_t>& counted);
  // Counts the levels that a texture operation is about to read, where running tells them; into the writer's body.
  void count(const SpirvInstruction& operation);
  // Loads how often this invocation has read a level.
  uint32_t sum(uint32_t binding, uint32_t level);
  // Whether the code asks the device for levels, and the module has not yet the capability for it (ImageQuery).
  bool needs_query() const;

 private:
  uint32_t pointer_to(uint32_t binding, uint32_t level);
  void add(uint32_t binding, uint32_t level, uint32_t amount);
  uint32_t lambda_of(const SpirvInstruction& operation, const LeveledTexture& texture);
  uint32_t texels_of(uint32_t gradient, const LeveledTexture& texture);
  uint32_t coordinates_of(const SpirvInstruction& operation);
  uint32_t vector(uint32_t components);

  SpirvWriter& code_;
  const Stage stage_;
  const LeveledTextures& textures_;
  std::map<uint32_t, uint32_t> sums_;  // by binding: the variable
  bool asks_ = false;
};

}  // namespace lamina
