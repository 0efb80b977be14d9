// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/common/checks.h"

#include <set>
#include <utility>

namespace lamina {
namespace {

constexpr uint32_t spirv_magic = 0x07230203;  // SPIR-V specification, section 2.3

[[noreturn]] void refuse(const std::string& subject, std::string message) {
  throw Error(ErrorKind::bad_input, "backend", subject, std::move(message));
}

void check_3d(const TextureDesc& desc, uint32_t most) {
  if (desc.depth == 0 || std::max({desc.width, desc.height, desc.depth}) > most)
    refuse(desc.name, fmt::format("{}x{}x{} is not a size that the device can make; each side of a 3D texture must be 1 to {}",
                                  desc.width, desc.height, desc.depth, most));
  if (desc.levels != 1 || desc.target || desc.storage || desc.format == Format::r32_uint || is_depth(desc.format))
    refuse(desc.name,
           "a 3D texture is sampled only: it has one level, is no target, no storage image, and holds no integers or depths");
}

void check_stages(const PipelineDesc& desc) {
  std::set<Stage> stages;
  for (const ShaderStage& stage : desc.stages) stages.insert(stage.stage);
  if (!is_compute(desc) && !(desc.stages.size() == 2 && stages == std::set{Stage::vertex, Stage::fragment}))
    refuse(desc.name, "a pipeline has a vertex and a fragment stage, or a compute stage alone");
  for (const ShaderStage& stage : desc.stages)
    if (stage.spirv.size() <= spirv_header_words || stage.spirv[0] != spirv_magic)
      throw Error(ErrorKind::failed, "backend", desc.name,
                  "a stage is not SPIR-V: its first word is not the magic number; compile the shader again");
}

void check_area(const Pass& pass, Extent whole) {
  if (!pass.area) return;
  const Area& area = *pass.area;
  const auto fits = [](uint32_t at, uint32_t size, uint32_t of) { return size > 0 && at < of && size <= of - at; };
  if (!fits(area.x, area.width, whole.width) || !fits(area.y, area.height, whole.height))
    refuse(pass.name, fmt::format("the area of {}x{} pixels at {},{} is empty or reaches out of targets of {}x{}", area.width,
                                  area.height, area.x, area.y, whole.width, whole.height));
}

}  // namespace

void check_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, uint32_t most, uint32_t most_3d) {
  if (desc.width == 0 || desc.height == 0 || desc.width > most || desc.height > most)
    refuse(desc.name, fmt::format("{}x{} is not a size that the device can make; each side must be 1 to {}", desc.width,
                                  desc.height, most));
  if (desc.depth != 1) check_3d(desc, most_3d);
  const uint32_t max_levels = full_mip_levels(desc.width, desc.height);
  if (desc.levels == 0 || desc.levels > max_levels)
    refuse(desc.name, fmt::format("{}x{} has 1 to {} mip levels, not {}", desc.width, desc.height, max_levels, desc.levels));
  if (levels.size() > desc.levels)
    refuse(desc.name, fmt::format("texels of {} levels for a texture of {}", levels.size(), desc.levels));
  for (uint32_t level = 0; level < levels.size(); ++level)
    if (levels[level].size() != level_bytes(desc, level))
      refuse(desc.name, fmt::format("level {} needs {} bytes of {}, not {}", level, level_bytes(desc, level),
                                    name_of(desc.format), levels[level].size()));
}

void check_level(const TextureDesc& desc, uint32_t level) {
  if (level >= desc.levels) refuse(desc.name, fmt::format("it has {} levels, there is no level {}", desc.levels, level));
}

void check_pipeline(const PipelineDesc& desc) {
  check_stages(desc);
  std::set<uint32_t> bindings;
  for (const BindingSlot& slot : desc.bindings)
    if (!bindings.insert(slot.binding).second) refuse(desc.name, fmt::format("binding {} is listed twice", slot.binding));
  if (!desc.blend.empty() && desc.blend.size() != desc.colors.size())
    refuse(desc.name,
           fmt::format("{} blends for {} colour targets; give one for each, or none", desc.blend.size(), desc.colors.size()));
  for (const Format format : desc.colors)
    if (is_depth(format)) refuse(desc.name, fmt::format("{} is not a colour format", name_of(format)));
  if (desc.depth_format && !is_depth(*desc.depth_format))
    refuse(desc.name, fmt::format("{} is not a depth format", name_of(*desc.depth_format)));
  if (desc.depth != Depth::none && !desc.depth_format) refuse(desc.name, "it tests depth and has no depth format");
  for (const uint32_t location : desc.vertex_locations)
    if (location >= vertex_offset_bytes.size())
      refuse(desc.name, fmt::format("the mesh has no vertex attribute at location {}; its locations are 0 to {}", location,
                                    vertex_offset_bytes.size() - 1));
}

Extent check_targets(const Pass& pass, const FindTexture& texture) {
  std::set<std::pair<TextureId, uint32_t>> drawn;
  Extent size;
  const auto add = [&](const Attachment& attachment, bool as_depth) {
    const TextureDesc& desc = texture(attachment.texture);
    if (!desc.target || attachment.level >= desc.levels || is_depth(desc.format) != as_depth)
      refuse(pass.name,
             fmt::format("'{}' level {} is not a {} target (made with target = {}, {} levels, {})", desc.name, attachment.level,
                         as_depth ? "depth" : "colour", desc.target, desc.levels, name_of(desc.format)));
    const Extent extent = level_extent(desc, attachment.level);
    if (!drawn.empty() && extent != size)
      refuse(pass.name, fmt::format("'{}' is {}x{} and the targets before it {}x{}; they must be of one size", desc.name,
                                    extent.width, extent.height, size.width, size.height));
    size = extent;
    drawn.emplace(attachment.texture, attachment.level);
  };
  for (const Attachment& color : pass.colors) add(color, false);
  if (pass.depth) add(*pass.depth, true);
  if (drawn.empty()) refuse(pass.name, "a raster pass needs a colour or depth target");
  for (const Draw& draw : pass.draws)
    for (const TextureBinding& read : draw.textures)
      if (read.level && drawn.contains({read.texture, *read.level}))
        refuse(pass.name,
               fmt::format("binding {} reads level {} of a texture, which the pass draws into", read.binding, *read.level));
  check_area(pass, size);
  return size;
}

void check_draw(const Pass& pass, const PipelineDesc& pipeline, const FindTexture& texture) {
  const bool compute = is_compute(pipeline);
  if (compute != (pass.kind == PassKind::compute))
    refuse(pass.name,
           fmt::format("pipeline '{}' is {}, the pass is not", pipeline.name, compute ? "for compute" : "for drawing"));
  if (compute) return;
  std::vector<Format> colors;
  for (const Attachment& color : pass.colors) colors.push_back(texture(color.texture).format);
  std::optional<Format> depth;
  if (pass.depth) depth = texture(pass.depth->texture).format;
  if (colors != pipeline.colors || depth != pipeline.depth_format)
    refuse(pass.name, fmt::format("pipeline '{}' was made for other target formats than the pass has", pipeline.name));
}

void check_copy(const Pass& pass, const TextureDesc& from, const TextureDesc& to) {
  if (pass.copy_from == pass.copy_to) refuse(pass.name, fmt::format("it copies '{}' into itself", from.name));
  if (is_3d(from) || is_3d(to))
    refuse(pass.name, fmt::format("'{}' or '{}' is a 3D texture, which is not copied", from.name, to.name));
  if (from.width != to.width || from.height != to.height || from.format != to.format)
    refuse(pass.name, fmt::format("'{}' is {}x{} of {}, '{}' is {}x{} of {}; a copy takes two alike", from.name, from.width,
                                  from.height, name_of(from.format), to.name, to.width, to.height, name_of(to.format)));
}

void check_dimensions(const PipelineDesc& pipeline, const BindingSlot& slot, const TextureDesc& texture) {
  if (is_3d(texture) != (slot.dimensions == 3))
    refuse(pipeline.name, fmt::format("binding {} is a sampler{}D, '{}' is a {} texture; give it one of the other kind",
                                      slot.binding, slot.dimensions, texture.name, is_3d(texture) ? "3D" : "2D"));
}

}  // namespace lamina
