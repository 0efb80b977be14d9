// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/nearest_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

double squared(glm::dvec3 v) { return glm::dot(v, v); }

double squared_to_segment(glm::dvec3 point, glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 along = to - from;
  const double length = squared(along), share = length > 0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0;
  return squared(point - from - share * along);
}

// To the plane, where the point stands over the triangle; else to its nearest edge.
double squared_to_triangle(glm::dvec3 point, const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  bool is_over = squared(normal) > 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = corners[i], &to = corners[(i + 1) % 3];
    is_over = is_over && glm::dot(glm::cross(to - from, point - from), normal) >= 0;
    nearest = std::min(nearest, squared_to_segment(point, from, to));
  }
  if (!is_over) return nearest;
  const double off = glm::dot(point - corners[0], normal);
  return off * off / squared(normal);
}

}  // namespace

double nearest_surface_m(const std::vector<Object>& objects, const View& view) {
  const glm::dvec3 eye(view.eye), ahead = glm::normalize(glm::dvec3(view.target) - eye);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Object& object : objects) {
    std::vector<glm::dvec3> places;
    places.reserve(object.mesh.vertices.size());
    for (const Vertex& vertex : object.mesh.vertices)
      places.emplace_back(glm::dmat4(object.world_from_object) * glm::dvec4(vertex.position, 1));
    for (size_t i = 0; i + 2 < object.mesh.indices.size(); i += 3) {
      const uint32_t* corner = &object.mesh.indices[i];
      const std::array<glm::dvec3, 3> corners = {places[corner[0]], places[corner[1]], places[corner[2]]};
      if (std::ranges::any_of(corners, [&](glm::dvec3 at) { return glm::dot(at - eye, ahead) > 0; }))
        nearest = std::min(nearest, squared_to_triangle(eye, corners));
    }
  }
  return std::sqrt(nearest);
}

void keep_what_is_near(View& view, const std::vector<Object>& objects) {
  // As in fit_depth, of the corner of a picture twice as wide as high.
  const double half_height = std::tan(glm::radians(double(view.fov_y_degrees)) / 2),
               corner_cosine = 1 / std::sqrt(1 + 5 * half_height * half_height);
  const double near_m = 0.95 * corner_cosine * nearest_surface_m(objects, view);
  view.near_m = static_cast<float>(std::min(double(view.near_m), std::max(near_m, 1e-5 * double(view.far_m))));
}

}  // namespace lamina
