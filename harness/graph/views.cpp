// SPDX-License-Identifier: Apache-2.0
// Products of several matrices are computed in doubles and rounded once.
#include "harness/graph/views.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lamina {
namespace {

// Metres around a sphere that are left free inside a light's clip box, so that rounding to floats pushes no point of it out:
// a part of its radius, and a few units in the last place of the coordinates.
double air_around(const BoundingSphere& sphere, double distance) {
  return sphere.radius / 32768.0 + (glm::length(glm::dvec3(sphere.centre)) + distance) / 4194304.0;
}

// Up in a light's map: the world's y, or z for a light that shines nearly along y (within 8 degrees).
glm::dvec3 up_for(glm::dvec3 direction) { return std::abs(direction.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1); }

ViewMatrices looking(glm::dvec3 eye, glm::dvec3 direction, glm::dmat4 clip_from_view) {
  clip_from_view[1] *= -1.0;  // GLM's y runs up, ours down
  return {glm::mat4(glm::lookAtRH(eye, eye + direction, up_for(direction))), glm::mat4(clip_from_view), glm::vec3(eye)};
}

// The mirror's plane in the space of its view, where the eye's reflection is the origin: dot(plane, (p, 1)) is the height of p
// above the face that the eye sees.
glm::dvec4 plane_in_view(const glm::dmat4& view_from_world, glm::dvec3 normal, double eye_height) {
  return {glm::dmat3(view_from_world) * normal, -eye_height};
}

// Puts depth 0 on the plane, whose negative side the origin is on. Depth z / w is a multiple of the height above the plane over
// the distance along the axis, and that grows along each ray from the origin. It is 1 at the corner of the far plane that is
// highest above the mirror, so nowhere more in the frustum.
void clip_at(glm::dmat4& clip_from_view, glm::dvec4 plane) {
  const glm::dmat4 view_from_clip = glm::inverse(clip_from_view);
  const glm::dvec4 in_clip = glm::transpose(view_from_clip) * plane;
  const glm::dvec4 corner = view_from_clip * glm::dvec4(in_clip.x < 0 ? -1 : 1, in_clip.y < 0 ? -1 : 1, 1, 1);
  const double highest = glm::dot(plane, corner);
  // Where the whole frustum is behind the mirror, nothing is drawn at any positive scale.
  const glm::dvec4 depth_row = highest > 0 ? plane / highest : plane;
  for (int column = 0; column < 4; ++column) clip_from_view[column][2] = depth_row[column];
}

}  // namespace

ViewMatrices eye_view(const View& view, uint32_t width_px, uint32_t height_px) {
  const float width = static_cast<float>(width_px), height = static_cast<float>(height_px);
  glm::mat4 clip_from_view = glm::perspectiveRH_ZO(glm::radians(view.fov_y_degrees), width / height, view.near_m, view.far_m);
  clip_from_view[1] *= -1.0f;  // GLM's y runs up, ours down
  return {glm::lookAtRH(view.eye, view.target, view.up), clip_from_view, view.eye};
}

std::optional<ViewMatrices> light_view(const Light& light, const BoundingSphere& casters) {
  const glm::dvec3 centre(casters.centre);
  const double radius = casters.radius;
  if (light.kind == Light::Kind::directional) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(light.direction));
    const double half = radius + air_around(casters, radius);
    return looking(centre - direction * radius, direction,
                   glm::orthoRH_ZO(-half, half, -half, half, radius - half, radius + half));
  }
  const glm::dvec3 position(light.position);
  const double distance = glm::distance(centre, position);
  if (!(distance > radius)) return std::nullopt;
  const double air = air_around(casters, distance);
  const double tangent = (radius + air) / std::sqrt((distance - radius) * (distance + radius));
  // Close to the sphere nearly all depth values lie near the light, and the free air would take too many of them.
  const double near = distance - radius - std::min(air, (distance - radius) / 32768), far = distance + radius + air;
  const double half = near * tangent;
  return looking(position, (centre - position) / distance, glm::frustumRH_ZO(-half, half, -half, half, near, far));
}

ViewMatrices mirror_view(const View& view, uint32_t width_px, uint32_t height_px, const MirrorPlane& mirror) {
  const ViewMatrices eye = eye_view(view, width_px, height_px);
  glm::dvec3 normal(mirror.normal);
  double eye_height = glm::dot(normal, glm::dvec3(view.eye)) - double(mirror.height);
  const glm::dvec3 eye_reflected = glm::dvec3(view.eye) - 2 * eye_height * normal;
  // p - 2 (dot(normal, p) - height) normal, the same for either face.
  glm::dmat4 reflected(glm::dmat3(1) - 2.0 * glm::outerProduct(normal, normal));
  reflected[3] = glm::dvec4(2.0 * double(mirror.height) * normal, 1);
  const glm::dmat4 view_from_world = glm::dmat4(eye.view_from_world) * reflected;

  if (eye_height < 0) normal = -normal, eye_height = -eye_height;
  glm::dmat4 clip_from_view(eye.clip_from_view);
  // An eye in the plane would see one depth along the whole of each ray.
  clip_at(clip_from_view, plane_in_view(view_from_world, normal, std::max(eye_height, 1e-3 * double(view.near_m))));
  for (int column = 0; column < 4; ++column) clip_from_view[column][0] *= -1.0;
  return {glm::mat4(view_from_world), glm::mat4(clip_from_view), glm::vec3(eye_reflected)};
}

}  // namespace lamina
