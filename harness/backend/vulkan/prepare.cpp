// SPDX-License-Identifier: Apache-2.0
// The first half of a frame: what each pass uses, in which layout, and whether it fits together.
#include <algorithm>
#include <functional>

#include "harness/backend/vulkan/formats.h"
#include "harness/backend/vulkan/frame.h"

namespace lamina::vulkan {

FrameRunner::PreparedPass FrameRunner::prepare(const Pass& pass) {
  PreparedPass prepared;
  if (pass.kind == PassKind::mips) prepare_mips(pass, prepared);
  if (pass.kind == PassKind::copy) prepare_copy(pass, prepared);
  if (pass.kind == PassKind::raster) prepare_targets(pass, prepared);
  if (pass.kind == PassKind::raster || pass.kind == PassKind::compute)
    for (const Draw& draw : pass.draws) prepare_draw(pass, draw, prepared);
  agree_on_layouts(prepared);
  return prepared;
}

void FrameRunner::prepare_targets(const Pass& pass, PreparedPass& prepared) {
  std::vector<const Attachment*> attachments;
  for (const Attachment& color : pass.colors) attachments.push_back(&color);
  if (pass.depth) attachments.push_back(&*pass.depth);
  if (attachments.empty()) throw_bad_input(pass.name, "a raster pass needs a colour or depth target");

  for (const Attachment* attachment : attachments) {
    const Texture& texture = resources_.at(attachment->texture, pass.name);
    const bool as_depth = pass.depth && attachment == &*pass.depth;
    if (!texture.desc.target || attachment->level >= texture.desc.levels || is_depth(texture.desc.format) != as_depth)
      throw_bad_input(pass.name, fmt::format("'{}' level {} is not a {} target (made with target = {}, {} levels, {})",
                                             texture.desc.name, attachment->level, as_depth ? "depth" : "colour",
                                             texture.desc.target, texture.desc.levels, name_of(texture.desc.format)));
    const VkExtent2D extent = level_extent(texture.desc, attachment->level);
    if (attachment != attachments.front() && (extent.width != prepared.extent.width || extent.height != prepared.extent.height))
      throw_bad_input(pass.name,
                      fmt::format("'{}' is {}x{} and the targets before it {}x{}; they must be of one size", texture.desc.name,
                                  extent.width, extent.height, prepared.extent.width, prepared.extent.height));
    prepared.extent = extent;
    use(attachment->texture, attachment->level,
        as_depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, pass, prepared);
  }
  check_levels(pass);
  check_area(pass, prepared.extent.width, prepared.extent.height);
}

void FrameRunner::prepare_draw(const Pass& pass, const Draw& draw, PreparedPass& prepared) {
  const Pipeline& pipeline = pipelines_.at(draw.pipeline, pass.name);
  const bool compute = pass.kind == PassKind::compute;
  if (pipeline.compute != compute)
    throw_bad_input(pass.name, fmt::format("pipeline '{}' is {}, the pass is not", pipeline.desc.name,
                                           pipeline.compute ? "for compute" : "for drawing"));
  if (compute) {
    for (size_t axis = 0; axis < 3; ++axis)
      if (draw.groups[axis] > device_.limits().maxComputeWorkGroupCount[axis])
        throw_bad_input(pass.name, fmt::format("{} work groups on axis {}, the device takes {}", draw.groups[axis], axis,
                                               device_.limits().maxComputeWorkGroupCount[axis]));
  } else {
    check_targets_match(pass, pipeline);
    if (!pipeline.desc.vertex_locations.empty() && resources_.at(draw.vertices, pass.name).use != BufferUse::vertex)
      throw_bad_input(pass.name,
                      fmt::format("pipeline '{}' draws from a buffer that was not made for vertices", pipeline.desc.name));
    if (draw.indices && resources_.at(draw.indices, pass.name).use != BufferUse::index)
      throw_bad_input(pass.name,
                      fmt::format("pipeline '{}' draws by a buffer that was not made for indices", pipeline.desc.name));
  }
  for (const TextureBinding& binding : draw.textures) {
    if (binding.level)
      use(binding.texture, *binding.level, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, pass, prepared);
    else
      use_whole(binding.texture, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, pass, prepared);
  }
  for (const ImageBinding& binding : draw.images) use(binding.texture, binding.level, VK_IMAGE_LAYOUT_GENERAL, pass, prepared);
  prepared.pipelines.push_back(&pipeline);
}

void FrameRunner::prepare_mips(const Pass& pass, PreparedPass& prepared) {
  const Texture& texture = resources_.at(pass.mips_of, pass.name);
  constexpr VkFormatFeatureFlags needed =
      VK_FORMAT_FEATURE_BLIT_SRC_BIT | VK_FORMAT_FEATURE_BLIT_DST_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if (!device_.supports(vk_format(texture.desc.format), needed))
    throw_failed(pass.name, fmt::format("{} cannot make mip levels of '{}' ({})", device_.info().device, texture.desc.name,
                                        name_of(texture.desc.format)));
  use_whole(pass.mips_of, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pass, prepared);
}

void FrameRunner::prepare_copy(const Pass& pass, PreparedPass& prepared) {
  check_copy(pass, resources_.at(pass.copy_from, pass.name).desc, resources_.at(pass.copy_to, pass.name).desc);
  use(pass.copy_from, 0, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pass, prepared);
  use(pass.copy_to, 0, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, pass, prepared);
}

void FrameRunner::check_targets_match(const Pass& pass, const Pipeline& pipeline) {
  const auto format_of = [&](const Attachment& attachment) { return resources_.at(attachment.texture, pass.name).desc.format; };
  std::vector<Format> colors;
  for (const Attachment& color : pass.colors) colors.push_back(format_of(color));
  std::optional<Format> depth;
  if (pass.depth) depth = format_of(*pass.depth);
  if (colors != pipeline.desc.colors || depth != pipeline.desc.depth_format)
    throw_bad_input(pass.name,
                    fmt::format("pipeline '{}' was made for other target formats than the pass has", pipeline.desc.name));
}

// A level used in two ways in one pass is in the layout that allows both.
void FrameRunner::use(TextureId id, uint32_t level, VkImageLayout layout, const Pass& pass, PreparedPass& prepared) {
  const TextureDesc& desc = resources_.at(id, pass.name).desc;
  if (level >= desc.levels)
    throw_bad_input(pass.name, fmt::format("'{}' has {} levels, there is no level {}", desc.name, desc.levels, level));
  const auto entry = prepared.layouts.try_emplace(id, desc.levels, VK_IMAGE_LAYOUT_UNDEFINED).first;
  VkImageLayout& known = entry->second[level];
  known = known == VK_IMAGE_LAYOUT_UNDEFINED || known == layout ? layout : VK_IMAGE_LAYOUT_GENERAL;
}

void FrameRunner::use_whole(TextureId id, VkImageLayout layout, const Pass& pass, PreparedPass& prepared) {
  const uint32_t levels = resources_.at(id, pass.name).desc.levels;
  for (uint32_t level = 0; level < levels; ++level) use(id, level, layout, pass, prepared);
  prepared.whole.insert(id);
}

// A view of all levels needs them in one layout.
void FrameRunner::agree_on_layouts(PreparedPass& prepared) {
  for (const TextureId id : prepared.whole) {
    std::vector<VkImageLayout>& levels = prepared.layouts.at(id);
    if (std::adjacent_find(levels.begin(), levels.end(), std::not_equal_to<>()) != levels.end())
      std::fill(levels.begin(), levels.end(), VK_IMAGE_LAYOUT_GENERAL);
  }
}

}  // namespace lamina::vulkan
