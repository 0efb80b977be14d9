// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/everything.h"

#include <algorithm>

#include "harness/scene/declare.h"

namespace lamina {
namespace {

// The first number of the whole scene at whose 0 the effect is not called for; "" where there is none.
std::string number_that_takes_away(const EffectManifest& effect) {
  for (const NeedManifest& need : effect.needs)
    if (effect.scene.number(need.name)) return need.name;
  return "";
}

}  // namespace

Scene scene_of_everything(const Scene& scene, const Library& library) {
  Scene everything = scene;
  const Plan plan = make_plan(library, scene);
  for (const EffectManifest& effect : library.effects) {
    const bool spoken_of = scene.effects.contains(effect.name);
    if (spoken_of && (effect.of_objects() || plan.of(effect.name)->called_for)) continue;
    const std::string number = number_that_takes_away(effect);
    if (!effect.of_objects() && number.empty()) continue;
    if (!spoken_of) apply_scene_keys(everything, effect, {}, library);
    if (!number.empty()) everything.effects.at(effect.name).numbers[number] = 0;
  }
  return everything;
}

EverythingPlan plan_of_everything(const Plan& plan, const Scene& everything) {
  EverythingPlan made{make_plan(*plan.library, everything, std::nullopt, Culling::off)};
  made.plan.chosen = plan.chosen;
  for (const EffectPlan& entry : made.plan.effects)
    if (!entry.called_for)
      made.cannot[entry.effect->name] = entry.effect->otherwise
                                            ? entry.effect->not_because
                                            : "the scene does not speak of it, and no number of it takes it away at 0";
  return made;
}

}  // namespace lamina
