// SPDX-License-Identifier: Apache-2.0
// Turns a graph into a Frame: makes targets, buffers and pipelines, and the passes ready that frame_passes.h plans.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "harness/graph/frame.h"
#include "harness/graph/frame_passes.h"

namespace lamina {

class FrameBuilder {
 public:
  FrameBuilder(Frame& frame, const Graph& graph);
  void build(TargetSharing sharing, const Frame* like);

 private:
  // A pass that is being made ready, and what it belongs to.
  struct Place {
    const PlannedPass& planned;
    Frame::Step& step;
    const GraphPass& pass() const { return *planned.of; }
  };

  void make_targets(FramePasses& passes, TargetSharing sharing, const Frame* like);
  void build_sequence(PlannedSequence& planned, Frame::Sequence& sequence);
  Frame::Step& begin_step(const PlannedSequence::Step& planned, Frame::Sequence& sequence);
  void end_step(size_t first_pass, Frame::Sequence& sequence);
  void finish_draw(const Place& place, const GraphDraw& draw, const Pass& into, Draw& command);
  void bind(const Place& place, const GraphDraw& draw, Draw& command);
  void bind_block(const Place& place, const GraphDraw& draw, const ShaderResource& block, Draw& command);
  BufferId buffer(const GraphPass& pass, const GraphDraw& draw, const ResolvedBuffer& buffer);
  PipelineId pipeline(const Place& place, const GraphDraw& draw, const Pass& into, Draw& command);
  CountedTexture counted_texture(const GraphDraw& draw, const Draw& command, size_t read);
  void count(const Place& place, const GraphDraw& draw, uint32_t binding, const std::map<uint32_t, CountedTexture>& textures,
             PipelineDesc& desc);
  void give_counters(Frame::Step& step, size_t first_pass, Frame::Sequence& sequence);

  Frame& frame_;
  SceneResources& resources_;
  Backend& backend_;
  const Scene& scene_;
  const Graph& graph_;
  // The blocks Frame that the first view's passes bind, so that the other views' can be put in their place.
  struct FrameBlock {
    ShaderResource layout;
    const GraphPass* pass;
    std::optional<size_t> light;
  };
  std::map<BufferId, FrameBlock> frame_blocks_;
  std::map<std::string, PipelineId> pipelines_;
  std::map<Resource, BufferId> buffers_;  // storage
  uint32_t next_word_ = 0;                // of the step's counter buffer, while it is being laid out
};

}  // namespace lamina
