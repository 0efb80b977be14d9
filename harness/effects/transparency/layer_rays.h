// SPDX-License-Identifier: Apache-2.0
// Every surface along a ray, by Intel's Embree: transparent ones, and the opaque one that ends it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct LayerHit {
  double distance_m = 0;
  size_t object = 0;  // of the scene
  bool transparent = false;
  glm::dvec3 position{0}, normal{0};  // world; the normal is unit, interpolated, and turned to the ray's origin
  double cosine = 0;                  // of the angle between them, 0 to 1
  glm::dvec2 uv{0};
};

class LayerRays {
 public:
  // The scene outlives this. Throws Error(failed) where Embree cannot be had.
  explicit LayerRays(const Scene& scene);

  // Surfaces from the origin on, the nearest first, up to and with the first opaque one: of a solid object, whose front faces
  // alone count, or of a transparent one whose opacity is 1 everywhere. Both sides of transparent surfaces count. Two triangles
  // that the ray meets at their common edge are one surface.
  std::vector<LayerHit> hits(glm::dvec3 origin, glm::dvec3 direction) const;

 private:
  struct Scenery;
  std::shared_ptr<const Scenery> scenery_;
};

}  // namespace lamina
