// SPDX-License-Identifier: Apache-2.0
// The passes of a frame before there is a device: which targets each draws into and how it loads them, and which targets its
// draws read. frame_builder.h makes them ready on a device; lifetimes.h says what of them shares memory.
//
// Loads: the first pass of a sequence that writes a target clears it (the frame to the scene's background with alpha 0, depth
// to the manifest's `clear_depth`, others to 0, or all to the manifest's `clear`), later ones keep what is there; a full-screen
// pass that does not blend discards instead. A pass that reads a target it also writes gets the target's other buffer to write,
// and later passes read that. Where it draws objects, which need not cover all, the target is copied into the other buffer
// first.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "harness/graph/targets.h"

namespace lamina {

struct PlannedPass {
  // Its TextureIds are places in the targets' textures. A draw has a binding for each of its reads in their order, without a
  // texture where the scene gives that, its storage images, and the number of its vertices or groups where no mesh says it.
  Pass pass;
  const GraphPass* of = nullptr;
  std::vector<const GraphDraw*> draws;  // beside pass.draws
  size_t step = 0;
  uint32_t repetition = 0, repetitions = 1;
  bool prepares = false;  // it clears or copies before the pass itself, and draws nothing
};

// The passes done once, or those of each frame. A step is one of the graph's.
struct PlannedSequence {
  struct Step {
    const GraphPass* pass = nullptr;
    bool turns = false;  // each repetition reads what the one before wrote
  };
  std::vector<Step> steps;
  std::vector<PlannedPass> passes;  // in order, by step and repetition
};

struct FramePasses {
  TargetTextures targets;
  std::array<TextureId, 2> frame_buffers;
  TextureId picture;  // the one of them that the frame ends in
  PlannedSequence once, frame;
};

// Points into the graph. Throws Error(bad_input) where a pass reads what it writes and the target has one buffer, and as
// target_size().
FramePasses make_frame_passes(const Graph& graph, const Scene& scene, FramePx size);

// "variant.pass", with the names of the draw's object, where asked for, and light.
std::string pass_label(const GraphPass& pass, const GraphDraw& draw, const Scene& scene, bool with_object);

}  // namespace lamina
