// SPDX-License-Identifier: Apache-2.0
// A configuration's frame of the timed build that has run: its passes are compiled, what is done once is done.
#pragma once

#include "harness/graph/frame.h"
#include "harness/plan/plan.h"

namespace lamina {

struct ReadyFrame {
  // Everything given must outlive this. Throws Error where a variant does not compile or the device refuses.
  ReadyFrame(SceneResources& resources, const Plan& plan, const Configuration& configuration, ShaderCache& shaders,
             const Parameters& parameters = {}, Timing timing = Timing::bracketed, const Frame* like = nullptr);

  Graph graph;
  Frame frame;
  std::string view;             // that was drawn: the scene's first
  std::vector<double> pass_ms;  // of that first frame, beside frame.frame_names(): compiling is in it; empty without timing
  double wall_ms = 0;           // of running it, with what is done once
};

}  // namespace lamina
