// SPDX-License-Identifier: Apache-2.0
// What rays meet in a scene, by Embree: the front faces of some objects that a truth is about, and of what is opaque.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "harness/scene/scene.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

struct SurfaceHit {
  size_t object, triangle;
  double distance_m;
  glm::dvec3 position, normal;  // world; the normal unit, as interpolated
  glm::dvec2 uv;
};

class SceneSurfaces {
 public:
  // The scene outlives this. Objects that are `chosen` are not opaque here. `albedo`: what an object shows.
  SceneSurfaces(const Scene& scene, const std::function<bool(const Object&)>& chosen,
                const std::function<const Texture&(const Object&)>& albedo);
  ~SceneSurfaces();

  // The nearest front face of a chosen object, unless something opaque is nearer.
  std::optional<SurfaceHit> chosen(glm::dvec3 from, glm::dvec3 direction) const;
  // The nearest front face of what is opaque.
  std::optional<SurfaceHit> opaque(glm::dvec3 from, glm::dvec3 direction) const;
  // Lambert's light on a surface, from all lights and from all around: what an albedo is multiplied by.
  glm::dvec3 diffuse(glm::dvec3 position, glm::dvec3 normal) const;
  // An opaque surface's light: its albedo at the base level times that. The background where there is no surface.
  glm::dvec3 light(const std::optional<SurfaceHit>& hit) const;
  // The texture coordinates where another ray meets the plane of the hit's triangle.
  glm::dvec2 uv_beside(const SurfaceHit& hit, glm::dvec3 from, glm::dvec3 direction) const;
  // Of any object that rays meet.
  const FilteredTexture& albedo(size_t object) const { return *albedos_[object]; }

 private:
  struct Faces;
  std::optional<SurfaceHit> nearest(const Faces& faces, glm::dvec3 from, glm::dvec3 direction) const;
  const Scene& scene_;
  std::unique_ptr<Faces> chosen_, opaque_;
  std::vector<std::unique_ptr<FilteredTexture>> albedos_;  // by object
};

}  // namespace lamina
