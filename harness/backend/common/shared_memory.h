// SPDX-License-Identifier: Apache-2.0
// Where textures that are needed at different times lie in one memory, or which of them are one texture. No device is needed.
#pragma once

#include <span>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

struct MemoryNeed {
  uint64_t bytes = 0, alignment = 1;  // alignment above 0
  Lifetime lifetime;
};
struct MemoryPlaces {
  std::vector<uint64_t> offsets;  // beside what was asked for: multiples of its alignment
  uint64_t bytes = 0;             // of the memory
};
// Greedy by size (Pisarchyk and Lee, "Efficient Memory Management for Deep Neural Net Inference", 2020, section 5.2): from the
// largest down, each in the smallest gap that fits between those already placed whose lifetimes overlap its own, else behind
// them. What is needed at one time never overlaps. Quadratic in their number.
MemoryPlaces place_in_memory(std::span<const MemoryNeed> needs);

// Of each texture the index of the first one that it is one with: its own where it is a texture of its own. Two are one where
// they are alike (size, levels, format, uses) and their lifetimes do not overlap. The fewest that this allows: in order of
// their first use each takes any that is free.
std::vector<size_t> reused_textures(std::span<const TransientDesc> descs);

// Of all levels, as the format says.
uint64_t texture_bytes(const TextureDesc& desc);

}  // namespace lamina
