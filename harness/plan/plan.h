// SPDX-License-Identifier: Apache-2.0
// What a scene calls for: which effects, on which objects, with which of their features, and why. An effect that is not called
// for costs nothing: no pass, no target, no texture, no shader code.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

struct FeaturePlan {
  std::string define;
  bool on = false;     // for at least one of the effect's objects
  std::string reason;  // a sentence without its full stop
};

struct EffectPlan {
  const EffectManifest* effect = nullptr;
  bool called_for = false;
  std::string reason;
  std::vector<size_t> objects;  // of the scene, that call for it and may be seen
  size_t unseen = 0;            // objects that call for it and are left out, because no view can see them
  std::vector<FeaturePlan> features;
};

// Whether what a scene does not call for is left out.
enum class Culling : uint8_t {
  on,
  off  // everything runs that can: plan/everything.h makes the scene for it
};

struct Plan {
  const Library* library = nullptr;
  Culling culling = Culling::on;
  std::vector<EffectPlan> effects;  // in drawing order, those not called for too
  // The solid objects, and those of effects that do not read the frame, by index.
  std::vector<size_t> all, opaque;
  // By effect: the variant at which it stands while another effect is compared, where that is not its baseline.
  std::map<std::string, const VariantManifest*, std::less<>> chosen;
  std::vector<std::shared_ptr<const VariantManifest>> own;  // of these: those whose parameters are chosen too

  const EffectPlan* of(std::string_view effect) const;
};

// Whether an effect that the scene calls for is drawn after this one and reads what is in the frame, its alpha too.
bool reads_frame_after(const Plan& plan, const EffectManifest& effect);

// In time linear in objects and effects, and in vertices of objects of effects with `only_where_seen`. The plan points into
// `library`. `aspect`: width over height of the frame; without one, no object is left out for being out of every view.
//
// With culling off every effect is called for that the scene has values for, objects keep effects whose needs they do not meet,
// and none is left out for being seen by nobody. What is a surface, which passes of all objects draw, is the same.
Plan make_plan(const Library& library, const Scene& scene, std::optional<double> aspect = std::nullopt,
               Culling culling = Culling::on);

// What a number or fact of the effect is worth for an object, or, without one or where the object has none, for the scene.
double needed_value(const EffectManifest& effect, const Scene& scene, const Object* object, std::string_view name);

// The definitions that the effect's shaders get for this object, or, null, for passes of the whole frame.
std::map<std::string, std::string> feature_defines(const EffectManifest& effect, const Scene& scene, const Object* object);
// The same in this plan: with culling off, those too whose shaders say that they draw the same at 0 (`at_zero`).
std::map<std::string, std::string> feature_defines(const Plan& plan, const EffectManifest& effect, const Scene& scene,
                                                   const Object* object);

// One variant for each effect that is called for, in drawing order.
using Configuration = std::vector<const VariantManifest*>;
// Every effect as it is chosen, else at its baseline, but `variant` for its own effect.
Configuration configuration_with(const Plan& plan, const VariantManifest& variant);
// Of these variants, by effect; effects that are not named stand as they are chosen, else at their baselines.
Configuration configuration_of(const Plan& plan, const std::map<std::string, const VariantManifest*, std::less<>>& variants);

}  // namespace lamina
