// SPDX-License-Identifier: Apache-2.0
// What rays meet around glass: the glass's own front faces, and what is opaque, by Embree.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "harness/effects/rough_refraction/glass_slab.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

struct SurfaceHit {
  size_t object;
  double distance_m;
  glm::dvec3 position, normal;  // world; the normal unit, as interpolated
  glm::dvec2 uv;
};

class SceneBehind {
 public:
  explicit SceneBehind(const Scene& scene);
  ~SceneBehind();

  // The nearest front face of glass, unless something opaque is nearer.
  std::optional<SurfaceHit> glass(glm::dvec3 from, glm::dvec3 direction) const;
  // The nearest front face of what is opaque.
  std::optional<SurfaceHit> opaque(glm::dvec3 from, glm::dvec3 direction) const;
  // An opaque surface's light: its albedo at the base level times Lambert's from all lights and the ambient light. The
  // background where there is no surface.
  glm::dvec3 light(const std::optional<SurfaceHit>& hit) const;

 private:
  struct Faces;
  std::optional<SurfaceHit> nearest(const Faces& faces, glm::dvec3 from, glm::dvec3 direction) const;
  const Scene& scene_;
  std::unique_ptr<Faces> glass_, opaque_;
  std::vector<std::unique_ptr<FilteredTexture>> albedos_;  // by object; of what is opaque
};

}  // namespace lamina
