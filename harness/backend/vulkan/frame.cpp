// SPDX-License-Identifier: Apache-2.0
// The second half of a frame: recording, submitting, timing.
#include "harness/backend/vulkan/frame.h"

#include <algorithm>

#include "harness/backend/vulkan/formats.h"

namespace lamina::vulkan {
namespace {

VkAttachmentLoadOp load_op(Load load) {
  switch (load) {
    case Load::clear:
      return VK_ATTACHMENT_LOAD_OP_CLEAR;
    case Load::keep:
      return VK_ATTACHMENT_LOAD_OP_LOAD;
    case Load::discard:
      return VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  }
  return VK_ATTACHMENT_LOAD_OP_CLEAR;
}

VkClearValue clear_value(Format format, const std::array<float, 4>& clear) {
  VkClearValue value{};
  for (size_t i = 0; i < 4; ++i) {
    if (format == Format::r32_uint)
      value.color.uint32[i] = static_cast<uint32_t>(clear[i]);
    else
      value.color.float32[i] = clear[i];
  }
  if (is_depth(format)) value.depthStencil = {clear[0], 0};
  return value;
}

}  // namespace

RunTimes FrameRunner::run(std::span<const Pass> passes, Timing timing) {
  std::vector<PreparedPass> prepared;
  std::vector<const Pipeline*> pipelines;
  for (const Pass& pass : passes) {
    prepared.push_back(prepare(pass));
    pipelines.insert(pipelines.end(), prepared.back().pipelines.begin(), prepared.back().pipelines.end());
  }
  descriptors_.start(pipelines);
  for (size_t i = 0; i < passes.size(); ++i)
    for (size_t draw = 0; draw < prepared[i].pipelines.size(); ++draw)
      prepared[i].sets.push_back(
          descriptors_.make_set(*prepared[i].pipelines[draw], passes[i].draws[draw], resources_, prepared[i].layouts));

  const bool timed = timing == Timing::bracketed;
  const uint32_t count = static_cast<uint32_t>(passes.size());
  const VkCommandBuffer commands = device_.begin();
  if (timed) timestamps_.start(commands, count + 1);
  samples_.start(commands, passes);
  for (uint32_t i = 0; i < count; ++i) {
    const std::vector<VkImageMemoryBarrier2> barriers = transitions(passes[i], prepared[i]);
    if (timed) timestamps_.mark(commands, i);
    full_barrier(commands, barriers);
    device_.begin_label(commands, passes[i].name);
    record(commands, passes[i], prepared[i], i);
    device_.end_label(commands);
  }
  if (timed) timestamps_.mark(commands, count);
  full_barrier(commands);

  RunTimes times;
  times.wall_ms = device_.submit_and_wait(commands);
  if (timed) times.pass_ms = timestamps_.read_ms();
  samples_.read(passes, times);
  return times;
}

std::vector<VkImageMemoryBarrier2> FrameRunner::transitions(const Pass& pass, const PreparedPass& prepared) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for (const auto& [id, layouts] : prepared.layouts) {
    Texture& texture = resources_.at(id, pass.name);
    for (uint32_t level = 0; level < layouts.size(); ++level)
      if (layouts[level] != VK_IMAGE_LAYOUT_UNDEFINED && layouts[level] != texture.layouts[level])
        barriers.push_back(transition(texture, level, layouts[level]));
  }
  return barriers;
}

void FrameRunner::record(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared, uint32_t index) {
  switch (pass.kind) {
    case PassKind::raster:
      return record_raster(commands, pass, prepared, index);
    case PassKind::compute:
      return record_compute(commands, pass, prepared);
    case PassKind::mips:
      return record_mips(commands, pass);
    case PassKind::copy:
      return record_copy(commands, pass);
  }
}

void FrameRunner::record_raster(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared, uint32_t index) {
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const Attachment& color : pass.colors) colors.push_back(attachment_info(color, prepared.layouts));
  VkRenderingAttachmentInfo depth{};
  if (pass.depth) depth = attachment_info(*pass.depth, prepared.layouts);

  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = {prepared.extent.width, prepared.extent.height};
  if (const std::optional<Area>& area = pass.area)
    info.renderArea = {{static_cast<int32_t>(area->x), static_cast<int32_t>(area->y)}, {area->width, area->height}};
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<uint32_t>(colors.size());
  info.pColorAttachments = colors.data();
  info.pDepthAttachment = pass.depth ? &depth : nullptr;
  vkCmdBeginRendering(commands, &info);

  const VkViewport viewport{0, 0, static_cast<float>(prepared.extent.width), static_cast<float>(prepared.extent.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &info.renderArea);
  samples_.begin(commands, pass, index);
  for (size_t i = 0; i < pass.draws.size(); ++i) {
    const Draw& draw = pass.draws[i];
    const Pipeline& pipeline = *prepared.pipelines[i];
    bind(commands, pipeline, prepared.sets[i]);
    if (!pipeline.desc.vertex_locations.empty()) {
      const VkBuffer vertices = resources_.at(draw.vertices, pass.name).buffer.get();
      const VkDeviceSize offset = 0;
      vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
    }
    if (draw.indices) {
      vkCmdBindIndexBuffer(commands, resources_.at(draw.indices, pass.name).buffer.get(), 0, VK_INDEX_TYPE_UINT32);
      vkCmdDrawIndexed(commands, draw.count, 1, 0, 0, 0);
    } else {
      vkCmdDraw(commands, draw.count, 1, 0, 0);
    }
  }
  samples_.end(commands, pass, index);
  vkCmdEndRendering(commands);
}

void FrameRunner::record_compute(VkCommandBuffer commands, const Pass& pass, const PreparedPass& prepared) {
  for (size_t i = 0; i < pass.draws.size(); ++i) {
    const Draw& draw = pass.draws[i];
    // Dispatches of one pass follow each other as draws do: each sees what the one before it wrote.
    if (i > 0) full_barrier(commands);
    bind(commands, *prepared.pipelines[i], prepared.sets[i]);
    vkCmdDispatch(commands, draw.groups[0], draw.groups[1], draw.groups[2]);
  }
}

// The whole image is a source on entry and on return; each level is a destination while it is filled.
void FrameRunner::record_mips(VkCommandBuffer commands, const Pass& pass) {
  const Texture& texture = resources_.at(pass.mips_of, pass.name);
  const VkImageAspectFlags aspect = aspect_of(texture.desc.format);
  for (uint32_t level = 1; level < texture.desc.levels; ++level) {
    const VkImageMemoryBarrier2 to_destination =
        transition(texture, level, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    full_barrier(commands, {&to_destination, 1});
    const Extent from = level_extent(texture.desc, level - 1), to = level_extent(texture.desc, level);
    VkImageBlit blit{};
    blit.srcSubresource = {aspect, level - 1, 0, 1};
    blit.srcOffsets[1] = {static_cast<int32_t>(from.width), static_cast<int32_t>(from.height), 1};
    blit.dstSubresource = {aspect, level, 0, 1};
    blit.dstOffsets[1] = {static_cast<int32_t>(to.width), static_cast<int32_t>(to.height), 1};
    vkCmdBlitImage(commands, texture.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, texture.image.get(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    const VkImageMemoryBarrier2 to_source =
        transition(texture, level, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    full_barrier(commands, {&to_source, 1});
  }
}

void FrameRunner::record_copy(VkCommandBuffer commands, const Pass& pass) {
  const Texture& from = resources_.at(pass.copy_from, pass.name);
  const Texture& to = resources_.at(pass.copy_to, pass.name);
  VkImageCopy region{};
  region.srcSubresource = region.dstSubresource = {aspect_of(from.desc.format), 0, 0, 1};
  region.extent = {from.desc.width, from.desc.height, 1};
  vkCmdCopyImage(commands, from.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image.get(),
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void FrameRunner::bind(VkCommandBuffer commands, const Pipeline& pipeline, VkDescriptorSet set) {
  const VkPipelineBindPoint point =
      is_compute(pipeline.desc) ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS;
  vkCmdBindPipeline(commands, point, pipeline.pipeline.get());
  vkCmdBindDescriptorSets(commands, point, pipeline.layout.get(), 0, 1, &set, 0, nullptr);
}

VkRenderingAttachmentInfo FrameRunner::attachment_info(const Attachment& attachment, const PassLayouts& layouts) {
  const Texture& texture = resources_.at(attachment.texture, "attachment");
  VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  info.imageView = texture.levels[attachment.level].get();
  info.imageLayout = layouts.at(attachment.texture)[attachment.level];
  info.loadOp = load_op(attachment.load);
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  info.clearValue = clear_value(texture.desc.format, attachment.clear);
  return info;
}

}  // namespace lamina::vulkan
