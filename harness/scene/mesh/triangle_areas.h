// SPDX-License-Identifier: Apache-2.0
// What a triangle of a mesh covers in space and in its texture.
#pragma once

#include <cmath>

#include "harness/scene/scene.h"

namespace lamina {

// Both doubled: of the surface in the mesh's own units squared, unwrapped in tiles.
struct TriangleAreas {
  double surface, unwrapped;
};

inline TriangleAreas doubled_areas(const Mesh& mesh, size_t triangle) {
  const uint32_t* corner = &mesh.indices[3 * triangle];
  const Vertex &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
  const glm::dvec2 uv_1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), uv_2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
  const glm::dvec3 side_1 = glm::dvec3(b.position) - glm::dvec3(a.position),
                   side_2 = glm::dvec3(c.position) - glm::dvec3(a.position);
  return {glm::length(glm::cross(side_1, side_2)), std::abs(uv_1.x * uv_2.y - uv_2.x * uv_1.y)};
}

}  // namespace lamina
