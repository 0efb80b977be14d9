// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/ready_frame.h"

namespace lamina {

ReadyFrame::ReadyFrame(SceneResources& resources, const Plan& plan, const VariantManifest& variant, ShaderCache& shaders)
    : graph(make_graph(plan, configuration_with(plan, variant), resources.scene(), shaders)),
      frame(resources, graph, Build::timed),
      view(resources.scene().views.front().name) {
  frame.run_once(Timing::off);
  pass_ms = frame.run(0, Timing::bracketed).pass_ms;
}

}  // namespace lamina
