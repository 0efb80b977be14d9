// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/target_uses.h"

#include <algorithm>
#include <set>

#include "harness/graph/targets.h"

namespace lamina {
namespace {

class Uses {
 public:
  Uses(const Graph& graph, const Scene& scene, uint32_t width_px, uint32_t height_px)
      : graph_(graph), scene_(scene), width_px_(width_px), height_px_(height_px) {
    const uint64_t pixels = uint64_t{width_px} * height_px;
    TargetUse& frame = all_.emplace_back();
    frame.name = "frame";
    frame.bytes = pixels * bytes_per_texel(frame_format) * frame_buffers(graph);
    TargetUse& depth = all_.emplace_back();
    depth.name = "depth";
    depth.bytes = pixels * bytes_per_texel(frame_depth_format);
  }

  void add(size_t index) {
    const GraphPass& pass = graph_.passes[index];
    const PassManifest& manifest = *pass.pass;
    for (const GraphDraw& draw : pass.draws) {
      for (const std::string& name : manifest.writes) note(of_target(pass, draw, name).writers, index);
      if (manifest.depth != Depth::none) {
        TargetUse& depth = manifest.depth_target.empty() ? all_[1] : of_target(pass, draw, manifest.depth_target);
        note(manifest.depth == Depth::read ? depth.readers : depth.writers, index);
      }
      for (const ResolvedRead& read : draw.reads) {
        if (read.source.kind == Source::Kind::frame) note(all_[0].readers, index);
        if (read.source.kind == Source::Kind::depth) note(all_[1].readers, index);
        if (read.source.kind == Source::Kind::target)
          note(of_target(pass, draw, read.source.name, read.source.light).readers, index);
      }
      for (const ResolvedBuffer& buffer : draw.buffers) {
        if (buffer.source.kind != Source::Kind::buffer) continue;
        TargetUse& use = of_buffer(pass, draw, buffer.source.name);
        note(use.writers, index);
        note(use.readers, index);
      }
    }
  }

  std::vector<TargetUse> take() { return std::move(all_); }

 private:
  // Passes come in order, so an index that is there is the last one.
  static void note(std::vector<size_t>& passes, size_t index) {
    if (passes.empty() || passes.back() != index) passes.push_back(index);
  }

  TargetUse& entry(const Resource& resource) {
    const auto found = std::ranges::find_if(
        all_, [&](const TargetUse& use) { return use.variant == resource.variant && use.name == resource.name; });
    if (found != all_.end()) return *found;
    TargetUse& made = all_.emplace_back();
    made.variant = resource.variant, made.name = resource.name, made.copies = 0;
    return made;
  }

  TargetUse& of_target(const GraphPass& pass, const GraphDraw& draw, const std::string& name,
                       std::optional<size_t> light = std::nullopt) {
    if (name == "frame") return all_[0];
    const TargetManifest& manifest = *pass.variant->target(name);
    const Resource resource = target_of(*pass.variant, name, draw, light);
    TargetUse& use = entry(resource);
    if (!made_.insert(resource).second) return use;
    const auto [width, height] = target_size(graph_, scene_, {width_px_, height_px_}, pass, manifest.size, resource.object);
    const Format format = pass.variant->format_of(manifest, graph_.parameters);
    use.bytes += manifest.buffers * texel_bytes(width, height, manifest.mips, format);
    use.shared = manifest.shared;
    ++use.copies;
    return use;
  }

  TargetUse& of_buffer(const GraphPass& pass, const GraphDraw& draw, const std::string& name) {
    const BufferManifest& manifest = *std::ranges::find(pass.variant->buffers, name, &BufferManifest::name);
    const Resource resource{pass.variant, name, manifest.scope == Scope::object ? draw.object : std::nullopt, std::nullopt};
    TargetUse& use = entry(resource);
    if (!made_.insert(resource).second) return use;
    use.bytes += buffer_bytes(manifest, scene_, {width_px_, height_px_}, resource.object);
    ++use.copies;
    return use;
  }

  const Graph& graph_;
  const Scene& scene_;
  uint32_t width_px_, height_px_;
  std::vector<TargetUse> all_;
  std::set<Resource> made_;
};

}  // namespace

std::vector<TargetUse> target_uses(const Graph& graph, const Scene& scene, uint32_t width_px, uint32_t height_px) {
  Uses uses(graph, scene, width_px, height_px);
  for (size_t i = 0; i < graph.passes.size(); ++i) uses.add(i);
  return uses.take();
}

}  // namespace lamina
