// SPDX-License-Identifier: Apache-2.0
// What every backend refuses, before it asks its API: textures and pipelines that no device could make, and passes, draws and
// bindings that do not fit together. All throw Error(bad_input, "backend", ...) about the texture, pipeline or pass.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// Pixels.
struct Extent {
  uint32_t width = 0, height = 0;
  bool operator==(const Extent&) const = default;
};
inline Extent level_extent(const TextureDesc& desc, uint32_t level) {
  return {std::max(1u, desc.width >> level), std::max(1u, desc.height >> level)};
}
// Of all slices, tightly packed.
inline size_t level_bytes(const TextureDesc& desc, uint32_t level) {
  const Extent extent = level_extent(desc, level);
  return size_t{extent.width} * extent.height * desc.depth * bytes_per_texel(desc.format);
}
inline bool is_compute(const PipelineDesc& desc) { return desc.stages.size() == 1 && desc.stages[0].stage == Stage::compute; }

// `most` and `most_3d`: texels on a side of a 2D and of a 3D texture. `levels`: as of create_texture().
void check_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, uint32_t most, uint32_t most_3d);
void check_level(const TextureDesc& desc, uint32_t level);

// Throws Error(failed) where a stage is no SPIR-V.
void check_pipeline(const PipelineDesc& desc);

using FindTexture = std::function<const TextureDesc&(TextureId)>;
// The size of a raster pass's targets. Throws where there are none, they were not made to be drawn into, or differ in size;
// where a draw reads the level of a texture that the pass draws into; and where the pass's area is empty or reaches out of
// them.
Extent check_targets(const Pass& pass, const FindTexture& texture);
// Throws where the pipeline is of another kind than the pass, or was made for targets of other formats.
void check_draw(const Pass& pass, const PipelineDesc& pipeline, const FindTexture& texture);
// Throws where the one texture cannot be copied into the other.
void check_copy(const Pass& pass, const TextureDesc& from, const TextureDesc& to);
// Throws where a slot for a texture is of other dimensions than the texture.
void check_dimensions(const PipelineDesc& pipeline, const BindingSlot& slot, const TextureDesc& texture);

// The one of a draw's textures, buffers or images that is for this slot. Throws where there is none: what an earlier draw has
// left bound must not stand in for it.
template <class Binding>
const Binding& binding_at(const BindingSlot& slot, const std::vector<Binding>& given, const PipelineDesc& pipeline) {
  const auto found = std::ranges::find(given, slot.binding, &Binding::binding);
  if (found == given.end())
    throw Error(ErrorKind::bad_input, "backend", pipeline.name, fmt::format("a draw leaves binding {} empty", slot.binding));
  return *found;
}

}  // namespace lamina
