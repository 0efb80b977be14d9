// SPDX-License-Identifier: Apache-2.0
// One descriptor set a draw, from a pool that is emptied every frame; and the samplers.
#pragma once

#include <array>
#include <map>
#include <span>

#include "harness/backend/vulkan/pipeline.h"
#include "harness/backend/vulkan/resources.h"

namespace lamina::vulkan {

// The layout that each level of each texture of a pass is in while the pass runs; undefined: as it is, the pass uses it not.
using PassLayouts = std::map<TextureId, std::vector<VkImageLayout>>;

class Descriptors {
 public:
  explicit Descriptors(Device& device);

  // Empties the pool and makes room for these draws' pipelines. Sets of the frame before are gone.
  void start(std::span<const Pipeline* const> pipelines);
  // A set with everything that the pipeline binds, found in `draw`. Throws Error(bad_input) where a binding is not given or is
  // of another kind, Error(failed) where the device cannot filter a texture's format.
  VkDescriptorSet make_set(const Pipeline& pipeline, const Draw& draw, Resources& resources, const PassLayouts& layouts);

 private:
  static constexpr size_t kinds = 4;  // of BindingKind

  Device& device_;
  std::array<SamplerHandle, sampler_count> samplers_;
  DescriptorPoolHandle pool_;
  std::array<uint32_t, kinds> capacity_{};
  uint32_t set_capacity_ = 0;
};

}  // namespace lamina::vulkan
