// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/prepare.h"

#include <algorithm>

#include "harness/backend/opengl/gl_format.h"

namespace lamina::gl {
namespace {

// The entry of `given` for a slot of the pipeline: what an earlier draw has left bound must never stand in for it.
template <class Binding>
const Binding& at_slot(const std::vector<Binding>& given, const BindingSlot& slot, const Pipeline& pipeline) {
  const auto found = std::find_if(given.begin(), given.end(), [&](const Binding& b) { return b.binding == slot.binding; });
  if (found == given.end()) throw_bad_input(pipeline.desc.name, fmt::format("a draw leaves binding {} empty", slot.binding));
  return *found;
}

BoundResource resolve(Resources& resources, const Draw& draw, const Pipeline& pipeline, const Pipeline::Slot& at) {
  BoundResource bound{.kind = at.slot.kind, .unit = at.unit};
  switch (at.slot.kind) {
    case BindingKind::texture: {
      const TextureBinding& given = at_slot(draw.textures, at.slot, pipeline);
      Texture& texture = resources.textures.at(given.texture);
      if (is_3d(texture.desc) != (at.slot.dimensions == 3))
        throw_bad_input(pipeline.desc.name,
                        fmt::format("binding {} is a sampler{}D, '{}' is a {} texture; give it one of the other kind",
                                    at.slot.binding, at.slot.dimensions, texture.desc.name, is_3d(texture.desc) ? "3D" : "2D"));
      // An integer texture under a linear sampler is incomplete, even to a shader that only fetches texels.
      const Sampler fetch{Filter::nearest, given.sampler.wrap};
      bound.name = given.level ? level_view(texture, *given.level) : texture.object.name();
      bound.sampler = resources.samplers.of(texture.desc.format == Format::r32_uint ? fetch : given.sampler);
      break;
    }
    case BindingKind::uniform_buffer:
    case BindingKind::storage_buffer:
      bound.name = resources.buffers.at(at_slot(draw.buffers, at.slot, pipeline).buffer).object.name();
      break;
    case BindingKind::storage_image: {
      const ImageBinding& given = at_slot(draw.images, at.slot, pipeline);
      const Texture& texture = resources.textures.at(given.texture);
      bound.name = texture.object.name();
      bound.level = static_cast<GLint>(given.level);
      bound.format = gl_format(texture.desc.format).internal;
      break;
    }
  }
  return bound;
}

void check_targets(Resources& resources, const Pass& pass, const Pipeline& pipeline) {
  std::vector<Format> colors;
  for (const Attachment& color : pass.colors) colors.push_back(resources.textures.at(color.texture).desc.format);
  std::optional<Format> depth;
  if (pass.depth) depth = resources.textures.at(pass.depth->texture).desc.format;
  if (colors != pipeline.desc.colors || depth != pipeline.desc.depth_format)
    throw_bad_input(pass.name,
                    fmt::format("pipeline '{}' was made for other target formats than the pass has", pipeline.desc.name));
}

PreparedDraw prepare(Resources& resources, const Pass& pass, const Draw& draw) {
  const Pipeline& pipeline = resources.pipelines.at(draw.pipeline);
  const bool compute = is_compute(pipeline.desc);
  if (compute != (pass.kind == PassKind::compute))
    throw_bad_input(pass.name, fmt::format("pipeline '{}' is {}, the pass is not", pipeline.desc.name,
                                           compute ? "for compute" : "for drawing"));
  if (!compute) check_targets(resources, pass, pipeline);

  PreparedDraw prepared{.pipeline = &pipeline, .draw = &draw};
  for (const Pipeline::Slot& slot : pipeline.slots) prepared.bound.push_back(resolve(resources, draw, pipeline, slot));
  if (!pipeline.desc.vertex_locations.empty()) {
    if (!draw.vertices)
      throw_bad_input(pass.name, fmt::format("pipeline '{}' draws without a vertex buffer", pipeline.desc.name));
    prepared.vertices = resources.buffers.at(draw.vertices).object.name();
  }
  if (draw.indices) prepared.indices = resources.buffers.at(draw.indices).object.name();
  return prepared;
}

PreparedPass prepare(Resources& resources, const Pass& pass) {
  PreparedPass prepared{.pass = &pass};
  if (pass.kind == PassKind::mips) prepared.mips_of = resources.textures.at(pass.mips_of).object.name();
  if (pass.kind == PassKind::copy) {
    const Texture& from = resources.textures.at(pass.copy_from);
    const Texture& to = resources.textures.at(pass.copy_to);
    check_copy(pass, from.desc, to.desc);
    prepared.copy = {from.object.name(), to.object.name(), static_cast<GLsizei>(from.desc.width),
                     static_cast<GLsizei>(from.desc.height)};
  }
  if (pass.kind == PassKind::raster) {
    prepared.target = resources.framebuffers.of(pass, resources.textures);
    check_levels(pass);
    check_area(pass, prepared.target.width, prepared.target.height);
  }
  for (const Attachment& color : pass.colors)
    prepared.colors.push_back({.load = color.load,
                               .clear = color.clear,
                               .integer = resources.textures.at(color.texture).desc.format == Format::r32_uint});
  for (const Draw& draw : pass.draws) prepared.draws.push_back(prepare(resources, pass, draw));
  return prepared;
}

}  // namespace

std::vector<PreparedPass> prepare(Resources& resources, std::span<const Pass> passes) {
  std::vector<PreparedPass> prepared;
  for (const Pass& pass : passes) prepared.push_back(prepare(resources, pass));
  return prepared;
}

}  // namespace lamina::gl
