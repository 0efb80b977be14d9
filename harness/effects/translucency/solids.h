// SPDX-License-Identifier: Apache-2.0
// The scene's surfaces as rays cross them, all of them and in order: where a ray goes into an object, where it comes out, and
// the smooth normal there. World space, metres. A closed mesh is entered as often as it is left.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "harness/bake/embree_scene.h"
#include "harness/scene/scene.h"

namespace lamina {

// What an object's inside does to light. Shaders have the same numbers.
struct Medium {
  glm::dvec3 extinction{0};  // 1/m
  double refraction_index = 1, multiple_scattering = 1, wrap = 0;
};

struct SurfaceCrossing {
  double distance = 0;  // along the ray, whose direction is unit
  size_t object = 0;
  bool entering = false;  // the ray goes in
  glm::dvec3 normal{0};   // unit, outward, interpolated from the vertices
};

class Solids {
 public:
  // The scene must outlive this. Throws Error(failed) where Embree has no memory left.
  explicit Solids(const Scene& scene);

  // From the nearest to the farthest, up to `most` metres. A face that two triangles share the edge of counts once.
  std::vector<SurfaceCrossing> crossings(glm::dvec3 origin, glm::dvec3 direction, double most = 1e30) const;
  // Where a ray that starts inside an object first comes out of it; none where its mesh is open there.
  std::optional<SurfaceCrossing> way_out(glm::dvec3 origin, glm::dvec3 direction, size_t object) const;

  // None for an object that lets no light through.
  const std::optional<Medium>& medium(size_t object) const { return media_[object]; }
  double radius_m() const { return radius_m_; }  // of a sphere around everything

 private:
  SurfaceCrossing crossing(const RTCRayHit& hit) const;

  const Scene& scene_;
  std::vector<std::optional<Medium>> media_;
  std::vector<size_t> object_of_;  // by Embree's geometry
  EmbreeScene embree_;
  double radius_m_ = 0;
};

}  // namespace lamina
