// SPDX-License-Identifier: Apache-2.0
// The points of an object whose visibility is baked: its vertices, or the texels of a map over its unwrap.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct SurfacePoint {
  glm::vec3 position{0};  // world
  glm::vec3 normal{0};    // unit; or 0 where the surface has none, and such a point sees nothing
};

struct SurfacePoints {
  std::vector<SurfacePoint> points;
  std::vector<std::vector<uint32_t>> neighbours;  // beside points, by index: those that one interpolates between
  uint32_t map_side = 0;                          // 0: a point a vertex, in their order
  std::vector<uint32_t> point_of_texel;           // of a map, row by row: the texel's own point, or the nearest one's
};

// A vertex whose normal has no length takes that of the triangles around it. Vertices at one place are neighbours.
SurfacePoints vertex_points(const Object& object);
// One point for every texel whose centre a triangle covers in the unwrap. Throws Error(failed) for an object whose unwrap is
// not unique, or that covers no texel.
SurfacePoints map_points(const Object& object, uint32_t map_side);

}  // namespace lamina
