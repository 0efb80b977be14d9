// SPDX-License-Identifier: Apache-2.0
// The targets of a frame while its passes are being built: known from when a pass first names them, with the size and format
// that their variant's parameters give, and which of two buffers is read and which written. No device is needed.
#pragma once

#include <array>
#include <map>

#include "harness/graph/graph.h"

namespace lamina {

struct FrameTarget {
  std::array<TextureId, 2> buffers;
  uint32_t current = 0;
  uint32_t width = 0, height = 0, levels = 1;
  Format format = Format::rgba16_float;
  bool written = false;  // in the sequence being built
};

struct FramePx {
  uint32_t width = 1, height = 1;
};

// The textures that targets are, before a device has made them: a TextureId of theirs is a place in `textures`.
struct TargetTextures {
  std::vector<TextureDesc> textures;
  // Targets as large as the frame, by variant and name.
  std::map<std::pair<const VariantManifest*, std::string>, TextureId> frame_sized;
};

class Targets {
 public:
  // All must outlive this.
  Targets(const Graph& graph, const Scene& scene, FramePx size, TargetTextures& made);

  FrameTarget& frame() { return frame_; }
  FrameTarget& depth() { return depth_; }
  // A pass's target by name, "frame" included, or the one that a resolved source names. `light`: of a source of a light's
  // target that is read from elsewhere.
  FrameTarget& target(const GraphPass& pass, const GraphDraw& draw, const std::string& name,
                      std::optional<size_t> light = std::nullopt);
  FrameTarget& source_target(const GraphPass& pass, const GraphDraw& draw, const Source& source);
  // Nothing is written yet in the sequence that begins.
  void begin_sequence();

 private:
  FrameTarget make(const std::string& label, uint32_t width, uint32_t height, Format format, bool mips, uint32_t buffers,
                   bool storage);
  const Graph& graph_;
  const Scene& scene_;
  FramePx size_;
  TargetTextures& made_;
  FrameTarget frame_, depth_;
  std::map<Resource, FrameTarget> targets_;
};

// Whether a source is a target, the frame or its depth, and no texture of the scene.
inline bool is_target(const Source& source) {
  return source.kind == Source::Kind::target || source.kind == Source::Kind::frame || source.kind == Source::Kind::depth;
}

// Whether the draw reads what it also writes under this name.
bool reads_back(const GraphPass& pass, const GraphDraw& draw, const std::string& name);

// ---- What targets take, known without a device --------------------------------------------------------------------------

inline constexpr Format frame_format = Format::rgba16_float, frame_depth_format = Format::d32_float;
// Whether it is one of the colour targets, or of the images of a compute pass.
bool writes(const PassManifest& pass, std::string_view name);
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
