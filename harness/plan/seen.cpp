// SPDX-License-Identifier: Apache-2.0
#include "harness/plan/seen.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

// Devices place vertices in single precision: a corner this much of its distance outside still counts as inside.
constexpr double plane_tolerance = 1e-5;

// The corners of the box around the mesh, in world space.
std::array<glm::dvec3, 8> box_corners(const Object& object) {
  glm::dvec3 low(object.mesh.vertices.front().position), high = low;
  for (const Vertex& vertex : object.mesh.vertices) {
    low = glm::min(low, glm::dvec3(vertex.position));
    high = glm::max(high, glm::dvec3(vertex.position));
  }
  std::array<glm::dvec3, 8> corners;
  for (size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4 corner((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z, 1);
    corners[i] = glm::dvec3(glm::dmat4(object.world_from_object) * corner);
  }
  return corners;
}

}  // namespace

bool may_be_seen(const Object& object, const View& view, double aspect) {
  if (object.mesh.vertices.empty()) return false;
  const glm::dvec3 eye(view.eye), forward = glm::normalize(glm::dvec3(view.target) - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(view.up))), up = glm::cross(right, forward);
  const double slope_y = std::tan(glm::radians(double(view.fov_y_degrees)) / 2), slope_x = slope_y * aspect;
  // Distances outside each plane, not to scale; a box is outside a plane where all of its corners are.
  std::array<bool, 6> outside;
  outside.fill(true);
  for (const glm::dvec3& corner : box_corners(object)) {
    const glm::dvec3 from_eye = corner - eye;
    const double x = glm::dot(from_eye, right), y = glm::dot(from_eye, up), z = glm::dot(from_eye, forward);
    const double beyond[] = {double(view.near_m) - z, z - double(view.far_m), x - z * slope_x,
                             -x - z * slope_x,        y - z * slope_y,        -y - z * slope_y};
    const double tolerance = plane_tolerance * (glm::length(from_eye) + glm::length(corner)) * (1 + slope_x);
    for (size_t plane = 0; plane < outside.size(); ++plane) outside[plane] = outside[plane] && beyond[plane] > tolerance;
  }
  return std::none_of(outside.begin(), outside.end(), [](bool is_outside) { return is_outside; });
}

}  // namespace lamina
