// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/pass_makeup.h"

#include <algorithm>

#include "harness/manifest/read_pass.h"

namespace lamina {
namespace {

uint64_t texels_of(const TextureDesc& target, uint32_t level) {
  return uint64_t{std::max(target.width >> level, 1u)} * std::max(target.height >> level, 1u);
}

std::string_view name_of_load(Load load) { return load == Load::clear ? "clear" : load == Load::keep ? "keep" : "discard"; }

void add_written(PassCounts& of, std::string_view format, std::string_view load, std::string_view combine, uint64_t texels) {
  const auto same = std::ranges::find_if(
      of.written, [&](const WrittenTexels& row) { return row.format == format && row.load == load && row.combine == combine; });
  if (same != of.written.end())
    same->texels += texels;
  else
    of.written.push_back({std::string(format), std::string(load), std::string(combine), texels});
}

}  // namespace

void add_makeup(PassCounts& of, const Pass& pass, const PassManifest& manifest,
                const std::map<TextureId, TextureDesc>& targets) {
  ++of.runs;
  if (pass.kind == PassKind::raster)
    for (const Draw& draw : pass.draws) of.triangles += draw.count / 3;
  for (size_t i = 0; i < pass.colors.size(); ++i) {
    const Attachment& color = pass.colors[i];
    const TextureDesc& target = targets.at(color.texture);
    const Blend blend = pass.draws.empty() || i >= manifest.blend.size() ? Blend::none : manifest.blend[i];
    add_written(of, name_of(target.format), name_of_load(color.load), name_of(blend), texels_of(target, color.level));
  }
  if (pass.depth) {
    const TextureDesc& target = targets.at(pass.depth->texture);
    const char* combine = pass.draws.empty() ? "none" : manifest.depth == Depth::read_write ? "test and write" : "test";
    add_written(of, name_of(target.format), name_of_load(pass.depth->load), combine, texels_of(target, pass.depth->level));
  }
  if (pass.kind == PassKind::copy) {
    const TextureDesc& target = targets.at(pass.copy_to);
    add_written(of, name_of(target.format), "copy", "none", texels_of(target, 0));
  }
  if (pass.kind == PassKind::mips) {
    const TextureDesc& target = targets.at(pass.mips_of);
    uint64_t texels = 0;
    for (uint32_t level = 1; level < target.levels; ++level) texels += texels_of(target, level);
    add_written(of, name_of(target.format), "mips", "none", texels);
  }
}

}  // namespace lamina
