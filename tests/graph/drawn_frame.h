// SPDX-License-Identifier: Apache-2.0
// A frame on a backend with all that it needs, kept alive together; its first view is drawn.
#pragma once

#include <optional>

#include "harness/graph/frame.h"

namespace lamina {

struct DrawnFrame {
  struct Choice {
    const VariantManifest* variant = nullptr;  // of its effect; all others, and all where it is null, are baselines
    uint32_t width = 16, height = 16;
    Parameters parameters = {};
    const VariantManifest* told = nullptr;  // as for make_graph()
    Build build = Build::timed;
    std::optional<double> aspect = std::nullopt;  // as for make_plan()
    TargetSharing sharing = TargetSharing::on;    // off where a truth is told: its targets are read back
  };
  DrawnFrame(Backend& backend, const Library& library, const Scene& scene, const Choice& choice)
      : plan(make_plan(library, scene, choice.aspect)),
        shaders(backend.info().api, library.shaders),
        bakes(scene, *library.code, DiskCache("")),
        resources(backend, scene, library, choice.width, choice.height, &bakes),
        graph(make_graph(plan, configuration(plan, choice.variant), scene, shaders, choice.told, choice.parameters)),
        frame(resources, graph, choice.build, choice.told ? TargetSharing::off : choice.sharing) {
    frame.run_once(Timing::off);
    frame.run(0, Timing::off);
  }

  static Configuration configuration(const Plan& plan, const VariantManifest* variant) {
    if (variant) return configuration_with(plan, *variant);
    Configuration baselines;
    for (const EffectPlan& entry : plan.effects)
      if (entry.called_for) baselines.push_back(&entry.effect->baseline());
    return baselines;
  }

  Image picture() { return frame.picture(); }

  Plan plan;
  ShaderCache shaders;
  Bakes bakes;
  SceneResources resources;
  Graph graph;
  Frame frame;
};

}  // namespace lamina
