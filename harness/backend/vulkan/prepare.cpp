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
  prepared.extent = check_targets(pass, find_texture(pass));
  for (const Attachment& color : pass.colors)
    use(color.texture, color.level, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, pass, prepared);
  if (pass.depth) use(pass.depth->texture, pass.depth->level, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, pass, prepared);
}

void FrameRunner::prepare_draw(const Pass& pass, const Draw& draw, PreparedPass& prepared) {
  const Pipeline& pipeline = pipelines_.at(draw.pipeline, pass.name);
  check_draw(pass, pipeline.desc, find_texture(pass));
  if (pass.kind == PassKind::compute) {
    for (size_t axis = 0; axis < 3; ++axis)
      if (draw.groups[axis] > device_.limits().maxComputeWorkGroupCount[axis])
        throw_bad_input(pass.name, fmt::format("{} work groups on axis {}, the device takes {}", draw.groups[axis], axis,
                                               device_.limits().maxComputeWorkGroupCount[axis]));
  } else {
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

FindTexture FrameRunner::find_texture(const Pass& pass) {
  return [this, &pass](TextureId id) -> const TextureDesc& { return resources_.at(id, pass.name).desc; };
}

// A level used in two ways in one pass is in the layout that allows both.
void FrameRunner::use(TextureId id, uint32_t level, VkImageLayout layout, const Pass& pass, PreparedPass& prepared) {
  const TextureDesc& desc = resources_.at(id, pass.name).desc;
  check_level(desc, level);
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
