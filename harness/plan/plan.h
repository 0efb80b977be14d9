// SPDX-License-Identifier: Apache-2.0
// What a scene calls for: which effects, on which objects, with which of their features, and why. An effect that is not called
// for costs nothing: no pass, no target, no texture, no shader code.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/plan/manifest.h"
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
  std::vector<size_t> objects;  // of the scene, that call for it
  std::vector<FeaturePlan> features;
};

struct Plan {
  std::vector<EffectPlan> effects;  // in drawing order, those not called for too

  const EffectPlan* of(std::string_view effect) const;
};

// What is known of an object, as numbers that manifests can ask about:
//   layers          1 where it has a layered material, else 0
//   apertures       1 where it is lit through baked apertures, else 0
//   aperture_texels texels on a side of its aperture map; 0 where apertures are of vertices
//   plain           1 where no effect of its own draws it, else 0
//   transparency    greatest transparency of the outer layer wherever it is seen, 0 to 1
//   seen_thickness  texels of the inner layer's base level; 0 where the inner layer is nowhere seen
std::map<std::string, double> facts_of(const Object& object);

// Throws Error(bad_input) when a manifest asks for a fact that there is not. The plan points into `library`.
Plan make_plan(const Library& library, const Scene& scene);

// The definitions that the effect's shaders get for this object.
std::map<std::string, std::string> feature_defines(const EffectManifest& effect, const Object& object);

// One variant for each effect that is called for, in drawing order.
using Configuration = std::vector<const VariantManifest*>;
// Every effect at its baseline, but `variant` for its own effect.
Configuration configuration_with(const Plan& plan, const VariantManifest& variant);

}  // namespace lamina
