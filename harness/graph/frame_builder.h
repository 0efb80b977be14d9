// SPDX-License-Identifier: Apache-2.0
// Turns a graph into a Frame: makes targets, buffers and pipelines, and writes the lists of backend passes.
//
// Loads: the first pass of a sequence that writes a target clears it (the frame to the scene's background with alpha 0, others
// to 0, or to the manifest's `clear`), later ones keep what is there; a full-screen pass that does not blend discards instead.
// A pass that reads a target it also writes gets the target's other buffer to write, and later passes read that.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/graph/frame.h"

namespace lamina {

class FrameBuilder {
 public:
  FrameBuilder(Frame& frame, const Graph& graph, const Parameters& parameters);
  void build();

 private:
  using Object = std::optional<size_t>;
  struct Target {
    std::array<TextureId, 2> buffers;
    uint32_t current = 0;
    uint32_t width = 0, height = 0, levels = 1;
    Format format = Format::rgba16_float;
    bool written = false;  // in the sequence being built
  };
  struct Key {
    const VariantManifest* variant;  // null: the harness's own
    std::string name;
    Object object;
    auto operator<=>(const Key&) const = default;
  };

  void build_sequence(bool once, Frame::Sequence& sequence);
  void build_step(const GraphPass& pass, Frame::Sequence& sequence);
  void build_repetition(const GraphPass& pass, uint32_t iteration, uint32_t count, Frame::Sequence& sequence);
  Pass begin_pass(const GraphPass& pass, const GraphDraw& draw);
  void attach(const GraphPass& pass, const GraphDraw& draw, Pass& into);
  Draw make_draw(const GraphPass& pass, const GraphDraw& draw, const Pass& into, Frame::Step& step, BufferId pass_uniforms);
  void bind(const GraphPass& pass, const GraphDraw& draw, BufferId pass_uniforms, Draw& command);
  PipelineId pipeline(const GraphPass& pass, const GraphDraw& draw, const Pass& into, Frame::Step& step, Draw& command);
  void count(const GraphPass& pass, const GraphDraw& draw, Frame::Step& step, PipelineDesc& desc, Draw& command);
  uint32_t repetitions(const GraphPass& pass);
  void give_counters(Frame::Step& step, size_t first_pass, Frame::Sequence& sequence);

  Target& target(const GraphPass& pass, const std::string& name, Object object);
  Target make_target(const std::string& label, uint32_t width, uint32_t height, Format format, bool mips, uint32_t buffers,
                     bool storage);
  BufferId storage_buffer(const GraphPass& pass, const std::string& name, Object object);
  BufferId iteration_uniforms(uint32_t iteration, uint32_t count);
  std::pair<uint32_t, uint32_t> size_of(const SizeRule& rule, Object object) const;
  Format format_of(const GraphPass& pass, const GraphDraw& draw, const Source& source);
  TextureId texture_of(const GraphPass& pass, const GraphDraw& draw, const Source& source);

  Frame& frame_;
  Backend& backend_;
  const Scene& scene_;
  const Graph& graph_;
  const Parameters& parameters_;
  std::map<Key, Target> targets_;
  std::map<Key, BufferId> buffers_;
  std::map<std::pair<uint32_t, uint32_t>, BufferId> iterations_;
  std::map<std::string, PipelineId> pipelines_;
  uint32_t next_word_ = 0;  // of the step's counter buffer, while it is being laid out
};

}  // namespace lamina
