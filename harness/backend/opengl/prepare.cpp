// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/prepare.h"

#include <algorithm>

#include "harness/backend/opengl/gl_format.h"

namespace lamina::gl {
namespace {

BoundResource resolve(Resources& resources, const Draw& draw, const Pipeline& pipeline, const Pipeline::Slot& at) {
  BoundResource bound{.kind = at.slot.kind, .unit = at.unit};
  switch (at.slot.kind) {
    case BindingKind::texture: {
      const TextureBinding& given = binding_at(at.slot, draw.textures, pipeline.desc);
      Texture& texture = resources.textures.at(given.texture, pipeline.desc.name);
      check_dimensions(pipeline.desc, at.slot, texture.desc);
      // An integer texture under a linear sampler is incomplete, even to a shader that only fetches texels.
      const Sampler fetch{Filter::nearest, given.sampler.wrap, given.sampler.wrap_v};
      bound.name = given.level ? level_view(texture, *given.level) : texture.object.name();
      bound.sampler = resources.samplers.of(texture.desc.format == Format::r32_uint ? fetch : given.sampler);
      break;
    }
    case BindingKind::uniform_buffer:
    case BindingKind::storage_buffer:
      bound.name =
          resources.buffers.at(binding_at(at.slot, draw.buffers, pipeline.desc).buffer, pipeline.desc.name).object.name();
      break;
    case BindingKind::storage_image: {
      const ImageBinding& given = binding_at(at.slot, draw.images, pipeline.desc);
      const Texture& texture = resources.textures.at(given.texture, pipeline.desc.name);
      bound.name = texture.object.name();
      bound.level = static_cast<GLint>(given.level);
      bound.format = gl_format(texture.desc.format).internal;
      break;
    }
  }
  return bound;
}

PreparedDraw prepare(Resources& resources, const Pass& pass, const Draw& draw, const FindTexture& find_texture) {
  const Pipeline& pipeline = resources.pipelines.at(draw.pipeline, pass.name);
  check_draw(pass, pipeline.desc, find_texture);

  PreparedDraw prepared{.pipeline = &pipeline, .draw = &draw};
  for (const Pipeline::Slot& slot : pipeline.slots) prepared.bound.push_back(resolve(resources, draw, pipeline, slot));
  if (!pipeline.desc.vertex_locations.empty()) {
    if (!draw.vertices)
      throw_bad_input(pass.name, fmt::format("pipeline '{}' draws without a vertex buffer", pipeline.desc.name));
    prepared.vertices = resources.buffers.at(draw.vertices, pass.name).object.name();
  }
  if (draw.indices) prepared.indices = resources.buffers.at(draw.indices, pass.name).object.name();
  return prepared;
}

PreparedPass prepare(Resources& resources, const Pass& pass) {
  const FindTexture find_texture = [&](TextureId id) -> const TextureDesc& {
    return resources.textures.at(id, pass.name).desc;
  };
  PreparedPass prepared{.pass = &pass};
  if (pass.kind == PassKind::mips) prepared.mips_of = resources.textures.at(pass.mips_of, pass.name).object.name();
  if (pass.kind == PassKind::copy) {
    const Texture& from = resources.textures.at(pass.copy_from, pass.name);
    const Texture& to = resources.textures.at(pass.copy_to, pass.name);
    check_copy(pass, from.desc, to.desc);
    prepared.copy = {from.object.name(), to.object.name(), static_cast<GLsizei>(from.desc.width),
                     static_cast<GLsizei>(from.desc.height)};
  }
  if (pass.kind == PassKind::raster) {
    prepared.size = check_targets(pass, find_texture);
    prepared.framebuffer = resources.framebuffers.of(pass, resources.textures);
  }
  for (const Attachment& color : pass.colors)
    prepared.colors.push_back(
        {.load = color.load, .clear = color.clear, .integer = find_texture(color.texture).format == Format::r32_uint});
  for (const Draw& draw : pass.draws) prepared.draws.push_back(prepare(resources, pass, draw, find_texture));
  return prepared;
}

}  // namespace

std::vector<PreparedPass> prepare(Resources& resources, std::span<const Pass> passes) {
  std::vector<PreparedPass> prepared;
  for (const Pass& pass : passes) prepared.push_back(prepare(resources, pass));
  return prepared;
}

}  // namespace lamina::gl
