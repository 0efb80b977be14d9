// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/targets.h"

#include <algorithm>

namespace lamina {
namespace {

bool writes(const PassManifest& pass, std::string_view name) {
  return std::find(pass.writes.begin(), pass.writes.end(), name) != pass.writes.end();
}

}  // namespace

uint32_t frame_buffers(const Graph& graph) {
  for (const GraphPass& pass : graph.passes)
    for (const GraphDraw& draw : pass.draws)
      if (writes(*pass.pass, "frame") && reads_back(pass, draw, "frame")) return 2;
  return 1;
}

bool reads_back(const GraphPass& pass, const GraphDraw& draw, const std::string& name) {
  if (pass.pass->levels != LevelWalk::none) return false;  // it reads another level than it writes
  return std::any_of(draw.reads.begin(), draw.reads.end(), [&](const ResolvedRead& read) {
    if (name == "frame") return read.source.kind == Source::Kind::frame;
    return read.source.kind == Source::Kind::target && read.source.name == name;
  });
}

Targets::Targets(SceneResources& resources, const Graph& graph, MadeResources& made)
    : resources_(resources), graph_(graph), made_(made) {
  const uint32_t width = resources.width_px(), height = resources.height_px();
  frame_ = make("frame", width, height, frame_format, false, frame_buffers(graph), false);
  depth_ = make("depth", width, height, frame_depth_format, false, 1, false);
}

void Targets::begin_sequence() {
  frame_.written = depth_.written = false;
  for (auto& [key, target] : targets_) target.written = false;
}

FrameTarget& Targets::target(const GraphPass& pass, const GraphDraw& draw, const std::string& name,
                             std::optional<size_t> light) {
  if (name == "frame") return frame_;
  const TargetManifest* manifest = pass.variant->target(name);
  if (!manifest)
    throw Error(ErrorKind::bad_input, "variants", pass.pass->where, fmt::format("'{}' is not a target of this variant", name));
  const Resource key = target_of(*pass.variant, name, draw, light);
  if (const auto found = targets_.find(key); found != targets_.end()) return found->second;
  const auto [width, height] = target_size(graph_, resources_.scene(), {resources_.width_px(), resources_.height_px()}, pass,
                                           manifest->size, key.object);
  const bool storage = std::any_of(pass.variant->passes.begin(), pass.variant->passes.end(), [&](const PassManifest& other) {
    return other.draw == DrawKind::compute && writes(other, name);
  });
  std::string label = pass.variant->name + "." + name;
  if (key.object) label += "." + resources_.scene().objects[*key.object].name;
  if (key.light) label += "." + resources_.scene().lights[*key.light].name;
  const Format format = pass.variant->format_of(*manifest, graph_.parameters);
  const FrameTarget made = make(label, width, height, format, manifest->mips, manifest->buffers, storage);
  if (!key.object && !key.light && width == resources_.width_px() && height == resources_.height_px())
    made_.frame_sized[{pass.variant, name}] = {made.buffers[0], made.format};
  return targets_[key] = made;
}

FrameTarget& Targets::source_target(const GraphPass& pass, const GraphDraw& draw, const Source& source) {
  if (source.kind == Source::Kind::frame) return frame_;
  if (source.kind == Source::Kind::depth) return depth_;
  return target(pass, draw, source.name, source.light);
}

FrameTarget Targets::make(const std::string& label, uint32_t width, uint32_t height, Format format, bool mips, uint32_t buffers,
                          bool storage) {
  FrameTarget made;
  made.width = width, made.height = height;
  made.levels = mips ? full_mip_levels(width, height) : 1;
  made.format = format;
  for (uint32_t i = 0; i < buffers; ++i) {
    TextureDesc desc;
    desc.name = label;
    desc.width = width, desc.height = height, desc.levels = made.levels;
    desc.format = format;
    desc.target = true, desc.storage = storage;
    made.buffers[i] = resources_.backend().create_texture(desc);
    made_.textures.push_back(made.buffers[i]);
    made_.targets[made.buffers[i]] = desc;
    made_.bytes += texel_bytes(width, height, mips, format);
  }
  return made;
}

std::pair<uint32_t, uint32_t> target_size(const Graph& graph, const Scene& scene, FramePx frame, const GraphPass& pass,
                                          const SizeRule& rule, std::optional<size_t> object) {
  const auto value = [&](const Setting& setting) { return pass.variant->value_of(setting, graph.parameters); };
  double width = value(rule.width), height = value(rule.height);
  if (rule.kind == SizeRule::Kind::frame) width = frame.width, height = frame.height;
  if (rule.kind == SizeRule::Kind::texture) {
    const Object& of = scene.objects[*object];
    const Texture* texture = nullptr;
    for (const EffectManifest* effect : {graph.library->otherwise(), pass.effect})
      if (const auto values = effect ? of.effects.find(effect->name) : of.effects.end(); values != of.effects.end())
        if (const auto found = values->second.textures.find(rule.texture); found != values->second.textures.end())
          texture = &found->second;
    if (!texture)
      throw Error(ErrorKind::bad_input, "variants", pass.variant->file.string(),
                  fmt::format("object '{}' has no texture '{}' for a target to be as large as", of.name, rule.texture));
    width = (*texture)->width, height = (*texture)->height;
  }
  const double scale = value(rule.scale);
  const auto scaled = [&](double size) { return static_cast<uint32_t>(std::max(1.0, size * scale + 0.5)); };
  return {scaled(width), scaled(height)};
}

uint64_t texel_bytes(uint32_t width, uint32_t height, bool mips, Format format) {
  uint64_t texels = 0;
  for (uint32_t level = 0; level < (mips ? full_mip_levels(width, height) : 1); ++level)
    texels += uint64_t{std::max(width >> level, 1u)} * std::max(height >> level, 1u);
  return texels * bytes_per_texel(format);
}

uint64_t buffer_bytes(const BufferManifest& buffer, const Scene& scene, FramePx frame, std::optional<size_t> object) {
  const uint64_t vertices = object ? scene.objects[*object].mesh.vertices.size() : 0;
  return buffer.bytes + buffer.bytes_per_vertex * vertices + buffer.bytes_per_pixel * (uint64_t{frame.width} * frame.height);
}

BufferId Targets::buffer(const GraphPass& pass, const GraphDraw& draw, const ResolvedBuffer& buffer) {
  if (buffer.source.kind == Source::Kind::baked) return resources_.baked_buffer(buffer.source, *draw.object);
  const auto manifest = std::find_if(pass.variant->buffers.begin(), pass.variant->buffers.end(),
                                     [&](const BufferManifest& known) { return known.name == buffer.source.name; });
  const std::optional<size_t> owner = manifest->scope == Scope::object ? draw.object : std::nullopt;
  BufferId& id = buffers_[{pass.variant, manifest->name, owner, std::nullopt}];
  if (id) return id;
  const std::vector<std::byte> zeros(
      buffer_bytes(*manifest, resources_.scene(), {resources_.width_px(), resources_.height_px()}, owner));
  id = resources_.backend().create_buffer(pass.variant->name + "." + manifest->name, BufferUse::storage, zeros.size(), zeros);
  made_.buffers.push_back(id);
  made_.bytes += zeros.size();
  return id;
}

}  // namespace lamina
