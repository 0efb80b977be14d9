// SPDX-License-Identifier: Apache-2.0
// Rays against the triangles of an object, one after another: slow, and nothing in it to go wrong.
// Source: Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Whether a ray from `origin` meets the object, from either side, anywhere ahead.
inline bool blocks(const Object& object, glm::dvec3 origin, glm::dvec3 direction) {
  const glm::dmat4 world(object.world_from_object);
  const auto place = [&](uint32_t i) { return glm::dvec3(world * glm::dvec4(object.mesh.vertices[i].position, 1)); };
  for (size_t i = 0; i < object.mesh.indices.size(); i += 3) {
    const glm::dvec3 a = place(object.mesh.indices[i]);
    const glm::dvec3 ab = place(object.mesh.indices[i + 1]) - a, ac = place(object.mesh.indices[i + 2]) - a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) continue;
    const glm::dvec3 to = origin - a, q = glm::cross(to, ab);
    const double u = glm::dot(to, p) / determinant, v = glm::dot(direction, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && glm::dot(ac, q) / determinant > 0) return true;
  }
  return false;
}

// By the divergence theorem: positive where a closed mesh faces outwards.
inline double enclosed_volume(const Mesh& mesh) {
  double six_volumes = 0;
  const auto place = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
  for (size_t i = 0; i < mesh.indices.size(); i += 3) six_volumes += glm::dot(place(i), glm::cross(place(i + 1), place(i + 2)));
  return six_volumes / 6;
}

}  // namespace lamina
