// SPDX-License-Identifier: Apache-2.0
// How far a ray runs inside a closed hull, by Intel's Embree: every crossing of the hull's surface, told apart by the side from
// which the ray comes.
#pragma once

#include <memory>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct FogRay {
  glm::dvec3 origin, direction;  // world; unit length
};

class HullRays {
 public:
  // Both sides count; the meshes are those of `objects`, in world space. Throws Error(failed) where Embree cannot be had.
  explicit HullRays(const std::vector<const Object*>& objects);

  // How often the hull lies around a point: 0 outside, negative where it is turned inside out.
  int around(glm::dvec3 point) const;
  // Metres of the ray up to `end_m` inside the hull, counted as often as surfaces are nested: the distances at which it leaves,
  // less those at which it enters. `around_origin` is around(ray.origin). Where a ray runs through an
  // edge, the length is that of a ray 1e-6 radians beside it.
  double length_m(const FogRay& ray, double end_m, int around_origin) const;
  // The distance to the first face that is turned to the origin; infinity where there is none.
  double first_front_m(const FogRay& ray) const;

 private:
  struct Scenery;
  std::shared_ptr<const Scenery> scenery_;
};

}  // namespace lamina
