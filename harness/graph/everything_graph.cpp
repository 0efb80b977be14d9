// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/everything_graph.h"

#include <algorithm>

namespace lamina {
namespace {

bool draws_something(const GraphPass& pass) {
  return pass.pass->draw == DrawKind::mips ||
         std::ranges::any_of(pass.draws, [](const GraphDraw& draw) { return !draw.stages.empty(); });
}

// Why the effect has no part; "" where it has one.
std::string why_not(const EverythingPlan& plan, const EffectPlan& entry, const Scene& everything, ShaderCache& shaders,
                    const Parameters& parameters) {
  const Configuration all = configuration_of(plan.plan, {});
  const auto own = std::ranges::find(all, entry.effect->name, [](const VariantManifest* variant) { return variant->effect; });
  try {
    const Graph graph = make_graph(plan.plan, {*own}, everything, shaders, nullptr, parameters);
    if (std::ranges::any_of(graph.passes, draws_something)) return "";
    return "every pass of it draws its own objects, and there is none (" + entry.effect->not_because + ")";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

Graph make_graph_of_everything(EverythingPlan& plan, const Plan& called_for, const Scene& everything, ShaderCache& shaders,
                               const Parameters& parameters) {
  for (EffectPlan& entry : plan.plan.effects) {
    if (!entry.called_for || called_for.of(entry.effect->name)->called_for) continue;
    std::string why = why_not(plan, entry, everything, shaders, parameters);
    if (why.empty()) continue;
    entry.called_for = false;
    plan.cannot[entry.effect->name] = std::move(why);
  }
  return make_graph(plan.plan, configuration_of(plan.plan, {}), everything, shaders, nullptr, parameters);
}

}  // namespace lamina
