// SPDX-License-Identifier: Apache-2.0
// Executes a list of passes. The whole list is checked and its descriptor sets are made before the first command is recorded,
// so that bad input leaves nothing half done.
#pragma once

#include <span>

#include "harness/backend/vulkan/descriptors.h"
#include "harness/backend/vulkan/timestamps.h"

namespace lamina::vulkan {

using Pipelines = Table<PipelineId, Pipeline>;

class FrameRunner {
 public:
  FrameRunner(Device& device, Resources& resources, Pipelines& pipelines)
      : device_(device), resources_(resources), pipelines_(pipelines), descriptors_(device), timestamps_(device) {}

  // As Backend::run.
  RunTimes run(std::span<const Pass> passes, Timing timing);

 private:
  struct PreparedPass {
    VkExtent2D extent{};
    PassLayouts layouts;
    std::vector<const Pipeline*> pipelines;  // of the draws
    std::vector<VkDescriptorSet> sets;       // of the draws
  };

  PreparedPass prepare(const Pass& pass);
  void prepare_targets(const Pass& pass, PreparedPass& prepared);
  void prepare_draw(const Pass& pass, const Draw& draw, PreparedPass& prepared);
  void prepare_mips(const Pass& pass, PreparedPass& prepared);
  void check_targets_match(const Pass& pass, const Pipeline& pipeline);
  void use(TextureId id, VkImageLayout layout, const Pass& pass, PreparedPass& prepared);

  void record(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared);
  void record_raster(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared);
  void record_compute(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared);
  void record_mips(VkCommandBuffer commands, const Pass& pass);
  void bind(VkCommandBuffer commands, const Pipeline& pipeline, VkDescriptorSet set);
  VkRenderingAttachmentInfo attachment_info(const Attachment& attachment, const PassLayouts& layouts);

  Device& device_;
  Resources& resources_;
  Pipelines& pipelines_;
  Descriptors descriptors_;
  Timestamps timestamps_;
};

}  // namespace lamina::vulkan
