// SPDX-License-Identifier: Apache-2.0
// Turns a graph into a Frame: makes targets, buffers and pipelines, and writes the lists of backend passes.
//
// Loads: the first pass of a sequence that writes a target clears it (the frame to the scene's background with alpha 0, depth
// to the manifest's `clear_depth`, others to 0, or all to the manifest's `clear`), later ones keep what is there; a full-screen
// pass that does not blend discards instead. A pass that reads a target it also writes gets the target's other buffer to write,
// and later passes read that. Where it draws objects, which need not cover all, the target is copied into the other buffer
// first.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "harness/graph/frame.h"
#include "harness/graph/targets.h"

namespace lamina {

class FrameBuilder {
 public:
  FrameBuilder(Frame& frame, const Graph& graph);
  void build();

 private:
  // One repetition of a pass.
  struct Repetition {
    const GraphPass& pass;
    Frame::Step& step;
    uint32_t index, count;
    std::vector<Pass>& passes;  // that are added to
  };

  void build_sequence(bool once, Frame::Sequence& sequence);
  void build_step(const GraphPass& pass, Frame::Sequence& sequence);
  void build_repetition(const Repetition& repetition);
  // Draws of one backend pass: all objects of a view, or one thing's.
  void build_pass(const Repetition& repetition, std::span<const GraphDraw> draws);
  void clear_unwritten(const Repetition& repetition, const GraphDraw& draw);
  void prepare_read_back(const Repetition& repetition, const GraphDraw& draw, std::vector<FrameTarget*>& turning);
  Pass begin_pass(const Repetition& repetition, const GraphDraw& draw);
  void attach(const Repetition& repetition, const GraphDraw& draw, Pass& into);
  Draw make_draw(const Repetition& repetition, const GraphDraw& draw, const Pass& into);
  void bind(const Repetition& repetition, const GraphDraw& draw, Draw& command);
  void bind_block(const Repetition& repetition, const GraphDraw& draw, const ShaderResource& block, Draw& command);
  PipelineId pipeline(const Repetition& repetition, const GraphDraw& draw, const Pass& into, Draw& command);
  // The one level of a target that a pass reads which walks along its levels.
  std::optional<uint32_t> level_read(const Repetition& repetition, const GraphDraw& draw, const ResolvedRead& read);
  CountedTexture counted_texture(const Repetition& repetition, const GraphDraw& draw, const ResolvedRead& read);
  void count(const Repetition& repetition, const GraphDraw& draw, uint32_t binding,
             const std::map<uint32_t, CountedTexture>& textures, PipelineDesc& desc);
  uint32_t repetitions(const GraphPass& pass);
  void give_counters(Frame::Step& step, size_t first_pass, Frame::Sequence& sequence);
  std::string label_of(const GraphPass& pass, const GraphDraw& draw, bool with_object) const;

  Frame& frame_;
  SceneResources& resources_;
  Backend& backend_;
  const Scene& scene_;
  const Graph& graph_;
  Targets targets_;
  // The blocks Frame that the first view's passes bind, so that the other views' can be put in their place.
  struct FrameBlock {
    ShaderResource layout;
    const GraphPass* pass;
    std::optional<size_t> light;
  };
  std::map<BufferId, FrameBlock> frame_blocks_;
  std::map<std::string, PipelineId> pipelines_;
  uint32_t next_word_ = 0;  // of the step's counter buffer, while it is being laid out
};

}  // namespace lamina
