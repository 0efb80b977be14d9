// SPDX-License-Identifier: Apache-2.0
// The surface of an object with skin, and the light that enters it: by rays and in doubles. Shares no code with shaders.
#pragma once

#include <memory>

#include "harness/bake/embree_scene.h"
#include "harness/bake/occluders.h"
#include "harness/effects/skin/profile.h"
#include "harness/effects/skin/surface_reflection.h"
#include "harness/scene/scene.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

struct SkinHit {
  glm::dvec3 position, flat_normal, smooth_normal, normal;  // world; unit; `normal`: with the normal map
  glm::dvec2 uv;
};

struct SkinLight {
  glm::dvec3 to_light, irradiance;  // at normal incidence
};
// What arrives of each light at a place, shadows aside.
SkinLight skin_light(const Light& light, glm::dvec3 position);

class SkinSurface {
 public:
  SkinSurface(const Scene& scene, const Occluders& occluders, size_t object);

  const DiffusionProfile& profile() const { return profile_; }
  const SurfaceReflection& reflection() const { return reflection_; }
  // All that a line through `middle` meets within this distance of it, in any order.
  void hits_along(glm::dvec3 middle, glm::dvec3 direction, double reach_m, std::vector<SkinHit>& hits) const;
  // Whether a light reaches a place of the disc in which its shadows' edges are softened: `disc` in the unit disc.
  bool lit(const Light& light, const SkinLight& arriving, glm::dvec3 position, glm::dvec3 smooth_normal, glm::dvec2 disc) const;
  // Irradiance that enters, times the albedo's root; `disc`: for all its shadows.
  glm::dvec3 entering(const SkinHit& hit, glm::dvec2 disc) const;
  // Clement's melanin applied.
  glm::dvec3 albedo(glm::dvec3 plain) const;
  double number(const char* name) const { return values_.numbers.find(name)->second; }

 private:
  SkinHit hit_of(uint32_t triangle, double u, double v) const;

  const Scene& scene_;
  const Occluders& occluders_;
  const Object& object_;
  const EffectValues& values_;
  EmbreeScene embree_;
  DiffusionProfile profile_;
  SurfaceReflection reflection_;
  FilteredTexture albedo_, normal_, specular_;
  glm::dmat3 linear_, normal_matrix_;
};

}  // namespace lamina
