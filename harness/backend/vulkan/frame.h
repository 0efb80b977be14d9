// SPDX-License-Identifier: Apache-2.0
// Executes a list of passes. The whole list is checked and its descriptor sets are made before the first command is recorded,
// so that bad input leaves nothing half done.
#pragma once

#include <set>
#include <span>

#include "harness/backend/vulkan/descriptors.h"
#include "harness/backend/vulkan/memory_turns.h"
#include "harness/backend/vulkan/sample_counts.h"
#include "harness/backend/vulkan/timestamps.h"

namespace lamina::vulkan {

using Pipelines = Table<PipelineId, Pipeline>;

class FrameRunner {
 public:
  FrameRunner(Device& device, Resources& resources, Pipelines& pipelines)
      : device_(device),
        resources_(resources),
        pipelines_(pipelines),
        descriptors_(device),
        timestamps_(device),
        samples_(device) {}

  // As Backend::run.
  RunTimes run(std::span<const Pass> passes, Timing timing);

 private:
  struct PreparedPass {
    Extent extent;
    PassLayouts layouts;
    std::set<TextureId> whole;               // textures that are used as a whole: their levels share a layout
    std::vector<TextureId> come;             // textures that come into memory that others had
    std::vector<const Pipeline*> pipelines;  // of the draws
    std::vector<VkDescriptorSet> sets;       // of the draws
  };

  PreparedPass prepare(const Pass& pass);
  void prepare_targets(const Pass& pass, PreparedPass& prepared);
  void prepare_draw(const Pass& pass, const Draw& draw, PreparedPass& prepared);
  void prepare_mips(const Pass& pass, PreparedPass& prepared);
  void prepare_copy(const Pass& pass, PreparedPass& prepared);
  FindTexture find_texture(const Pass& pass);
  void use(TextureId id, uint32_t level, VkImageLayout layout, const Pass& pass, PreparedPass& prepared);
  void use_whole(TextureId id, VkImageLayout layout, const Pass& pass, PreparedPass& prepared);
  static void agree_on_layouts(PreparedPass& prepared);

  // The barriers that bring every level that the pass uses into its layout.
  std::vector<VkImageMemoryBarrier2> transitions(const Pass& pass, const PreparedPass& prepared);
  void record(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared, uint32_t index);
  void record_raster(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared, uint32_t index);
  void record_compute(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared);
  void record_mips(VkCommandBuffer commands, const Pass& pass);
  void record_copy(VkCommandBuffer commands, const Pass& pass);
  void bind(VkCommandBuffer commands, const Pipeline& pipeline, VkDescriptorSet set);
  VkRenderingAttachmentInfo attachment_info(const Attachment& attachment, const PassLayouts& layouts);

  Device& device_;
  Resources& resources_;
  Pipelines& pipelines_;
  Descriptors descriptors_;
  Timestamps timestamps_;
  SampleCounts samples_;
};

}  // namespace lamina::vulkan
