// SPDX-License-Identifier: Apache-2.0
// The targets and storage buffers of a frame while it is being built: made when a pass first names them, with the size and
// format that their variant's parameters give, and which of two buffers is read and which written.
#pragma once

#include <array>
#include <functional>
#include <map>

#include "harness/graph/graph.h"
#include "harness/graph/scene_resources.h"

namespace lamina {

struct FrameTarget {
  std::array<TextureId, 2> buffers;
  uint32_t current = 0;
  uint32_t width = 0, height = 0, levels = 1;
  Format format = Format::rgba16_float;
  bool written = false;  // in the sequence being built
};

// What was made, for whoever gives it back.
struct MadeResources {
  std::vector<TextureId> textures;
  std::vector<BufferId> buffers;
  std::map<TextureId, TextureDesc> targets;  // every target
  uint64_t bytes = 0;                        // of all of them, as their formats say
  // Targets as large as the frame, by variant and name.
  std::map<std::pair<const VariantManifest*, std::string>, std::pair<TextureId, Format>> frame_sized;
};

class Targets {
 public:
  // All must outlive this.
  Targets(SceneResources& resources, const Graph& graph, MadeResources& made);

  FrameTarget& frame() { return frame_; }
  FrameTarget& depth() { return depth_; }
  // A pass's target by name, "frame" included, or the one that a resolved source names. `light`: of a source of a light's
  // target that is read from elsewhere.
  FrameTarget& target(const GraphPass& pass, const GraphDraw& draw, const std::string& name,
                      std::optional<size_t> light = std::nullopt);
  FrameTarget& source_target(const GraphPass& pass, const GraphDraw& draw, const Source& source);
  BufferId buffer(const GraphPass& pass, const GraphDraw& draw, const ResolvedBuffer& buffer);
  // Nothing is written yet in the sequence that begins.
  void begin_sequence();

 private:
  FrameTarget make(const std::string& label, uint32_t width, uint32_t height, Format format, bool mips, uint32_t buffers,
                   bool storage);
  SceneResources& resources_;
  const Graph& graph_;
  MadeResources& made_;
  FrameTarget frame_, depth_;
  std::map<Resource, FrameTarget> targets_;
  std::map<Resource, BufferId> buffers_;
};

// Whether the draw reads what it also writes under this name.
bool reads_back(const GraphPass& pass, const GraphDraw& draw, const std::string& name);

// ---- What targets take, known without a device --------------------------------------------------------------------------

inline constexpr Format frame_format = Format::rgba16_float, frame_depth_format = Format::d32_float;
struct FramePx {
  uint32_t width = 1, height = 1;
};
// 2 where some pass reads the frame that it writes, else 1.
uint32_t frame_buffers(const Graph& graph);
// Of a pass's target, in texels: as its rule says, of the frame's size, of a texture of the object, or fixed. Throws
// Error(bad_input) where the object has no such texture.
std::pair<uint32_t, uint32_t> target_size(const Graph& graph, const Scene& scene, FramePx frame, const GraphPass& pass,
                                          const SizeRule& rule, std::optional<size_t> object);
// Of one texture, all levels.
uint64_t texel_bytes(uint32_t width, uint32_t height, bool mips, Format format);
// Of one storage buffer. `object`: whose it is.
uint64_t buffer_bytes(const BufferManifest& buffer, const Scene& scene, FramePx frame, std::optional<size_t> object);

}  // namespace lamina
