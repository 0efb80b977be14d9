// SPDX-License-Identifier: Apache-2.0
// Every card along a ray, by Embree, nearest first. Where a triangle is crossed is computed anew in doubles.
#pragma once

#include <memory>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct CardHit {
  size_t object;
  double distance_m;
  glm::dvec3 position, normal;       // world; the normal and what follows as interpolated from the vertices, not unit
  glm::dvec4 tangent;                // world; w = handedness
  glm::dvec2 uv, uv_right, uv_down;  // the last two: where the neighbouring rays meet the triangle's plane
};

class CardRays {
 public:
  explicit CardRays(const Scene& scene);
  ~CardRays();

  // Hits before whatever opaque the ray meets. Directions are unit; `right` and `down` are those of the next rays of the
  // picture.
  std::vector<CardHit> hits(glm::dvec3 eye, glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const;

 private:
  struct Cards;
  const Scene& scene_;
  std::unique_ptr<Cards> cards_, opaque_;
};

}  // namespace lamina
