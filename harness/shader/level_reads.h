// SPDX-License-Identifier: Apache-2.0
// Which levels of a texture one texture operation reads: known from the module, or to be counted as it runs.
//
// An operation reads the level at lambda, clamped to the levels that there are and rounded to 1/256, as precise as devices take
// it, or where that lies between two levels both of them. lambda is 0 where the sampler does not filter between levels, and for
// gathers; the operand of an explicit level of detail; log2 of the longer of the two gradients, in texels, of explicit
// gradients; else what the device answers to OpImageQueryLod at the same coordinates and the same place of the shader, plus the
// bias. Source: Khronos, Vulkan 1.3 specification, section 16.5.9 (scale factor, level of detail and image level selection).
// Limits: a device may take other levels than the one it tells: llvmpipe blends two levels only in the middle half between
// them, and its logarithm errs by up to 0.09.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

class SpirvModule;
struct SpirvInstruction;

// What is known of a texture before the shader runs.
struct LeveledTexture {
  uint32_t levels = 1;                       // 1 to 32
  bool mipmapped = false;                    // its sampler filters between levels; else it is sampled at level 0
  std::array<uint32_t, 3> size = {1, 1, 1};  // of level 0, in texels
  bool operator==(const LeveledTexture&) const = default;
};
using LeveledTextures = std::map<uint32_t, LeveledTexture>;  // by binding

inline constexpr float level_steps = 256;  // between two levels

struct LevelReads {
  enum class Told : uint8_t { here, by_running, never } told = Told::never;
  std::vector<uint32_t> levels;  // told here: one or two
};
// `operation`: a texture operation (is_texture_operation).
LevelReads level_reads(const SpirvModule& module, const SpirvInstruction& operation, Stage stage,
                       const LeveledTexture& texture);

bool is_texture_operation(const SpirvInstruction& instruction);
// Whether it takes one texel, without a filter.
bool is_texel_fetch(const SpirvInstruction& operation);
bool is_projective(const SpirvInstruction& operation);
// The operand that follows this bit of the operation's image operands, or 0. Of OpImageFetch too.
uint32_t image_operand(const SpirvInstruction& operation, uint32_t mask, uint32_t which = 0);
// The binding of the texture that it reads. Throws Error(failed) where that cannot be told.
uint32_t texture_binding(const SpirvModule& module, const SpirvInstruction& operation);

}  // namespace lamina
