// SPDX-License-Identifier: Apache-2.0
// Where a ray meets the plane of a triangle, in doubles (T. Moeller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle
// Intersection", Journal of Graphics Tools 2(1), 1997).
#pragma once

#include <glm/glm.hpp>

namespace lamina {

struct PlaneHit {
  double b, c;        // weights of the second and third corner there; outside the triangle some weight is below 0
  double distance_m;  // for a unit direction; below 0 behind the origin
  double facing;      // above 0 where the front, whose corners turn to the left, faces the origin; 0: the ray never meets it
};

inline PlaneHit plane_hit(glm::dvec3 first, glm::dvec3 second, glm::dvec3 third, glm::dvec3 origin, glm::dvec3 direction) {
  const glm::dvec3 along = second - first, across = third - first, turned = glm::cross(direction, across);
  const glm::dvec3 from = origin - first, beside = glm::cross(from, along);
  const double facing = glm::dot(along, turned);
  return {glm::dot(from, turned) / facing, glm::dot(direction, beside) / facing, glm::dot(across, beside) / facing, facing};
}

}  // namespace lamina
