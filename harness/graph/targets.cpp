// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/targets.h"

#include <algorithm>

#include "harness/backend/common/shared_memory.h"

namespace lamina {

bool writes(const PassManifest& pass, std::string_view name) {
  return std::find(pass.writes.begin(), pass.writes.end(), name) != pass.writes.end();
}

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

Targets::Targets(const Graph& graph, const Scene& scene, FramePx size, TargetTextures& made)
    : graph_(graph), scene_(scene), size_(size), made_(made) {
  frame_ = make("frame", size.width, size.height, frame_format, false, frame_buffers(graph), false);
  depth_ = make("depth", size.width, size.height, frame_depth_format, false, 1, false);
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
  const auto [width, height] = target_size(graph_, scene_, size_, pass, manifest->size, key.object);
  const bool storage = std::any_of(pass.variant->passes.begin(), pass.variant->passes.end(), [&](const PassManifest& other) {
    return other.draw == DrawKind::compute && writes(other, name);
  });
  std::string label = pass.variant->name + "." + name;
  if (key.object) label += "." + scene_.objects[*key.object].name;
  if (key.light) label += "." + scene_.lights[*key.light].name;
  const Format format = pass.variant->format_of(*manifest, graph_.parameters);
  const FrameTarget made = make(label, width, height, format, manifest->mips, manifest->buffers, storage);
  if (!key.object && !key.light && width == size_.width && height == size_.height)
    made_.frame_sized[{pass.variant, name}] = made.buffers[0];
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
    made.buffers[i] = TextureId{static_cast<uint32_t>(made_.textures.size())};
    made_.textures.push_back(std::move(desc));
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
  return texture_bytes(
      {.width = width, .height = height, .levels = mips ? full_mip_levels(width, height) : 1, .format = format});
}

uint64_t buffer_bytes(const BufferManifest& buffer, const Scene& scene, FramePx frame, std::optional<size_t> object) {
  const uint64_t vertices = object ? scene.objects[*object].mesh.vertices.size() : 0;
  return buffer.bytes + buffer.bytes_per_vertex * vertices + buffer.bytes_per_pixel * (uint64_t{frame.width} * frame.height);
}

}  // namespace lamina
