// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/ready_frame.h"

namespace lamina {

ReadyFrame::ReadyFrame(SceneResources& resources, const Plan& plan, const Configuration& configuration, ShaderCache& shaders,
                       const Parameters& parameters, Timing timing, const Frame* like)
    : graph(make_graph(plan, configuration, resources.scene(), shaders, nullptr, parameters)),
      frame(resources, graph, Build::timed, TargetSharing::on, like),
      view(resources.scene().views.front().name) {
  wall_ms = frame.run_once(Timing::off).wall_ms;
  const FrameTimes first = frame.run(0, timing);
  pass_ms = first.pass_ms;
  wall_ms += first.wall_ms;
}

}  // namespace lamina
