// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/default_views.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr float fov_y_degrees = 40;
constexpr float margin = 1.04f;  // air around the sphere
// Where the grazing view touches: right, above and in front, lit by the key light.
const glm::vec3 grazing_side = glm::normalize(glm::vec3(0.35f, 0.55f, 0.75f));
// In radii: how far the grazing eye stands above the touching plane, and how far back from the touching point. On a sphere it
// then meets the surface at 10 degrees or less over most of the picture.
constexpr float grazing_height = 0.05f, grazing_distance = 0.35f;

template <class Visit>
void for_each_world_position(const std::vector<Object>& objects, const Visit& visit) {
  for (const Object& object : objects)
    for (const Vertex& vertex : object.mesh.vertices)
      visit(glm::vec3(object.world_from_object * glm::vec4(vertex.position, 1)));
}

View seen_from(std::string name, const BoundingSphere& bounds, glm::vec3 direction) {
  View view;
  view.name = std::move(name);
  view.fov_y_degrees = fov_y_degrees;
  // The cone of view touches the sphere where sin(fov / 2) = radius / distance.
  const float distance = margin * bounds.radius / std::sin(glm::radians(fov_y_degrees) / 2);
  view.eye = bounds.centre + distance * glm::normalize(direction);
  view.target = bounds.centre;
  fit_depth(view, bounds);
  return view;
}

}  // namespace

BoundingSphere bounding_sphere(const std::vector<Object>& objects) {
  glm::vec3 low(INFINITY), high(-INFINITY);
  for_each_world_position(objects, [&](glm::vec3 p) { low = glm::min(low, p), high = glm::max(high, p); });
  BoundingSphere sphere{low + (high - low) / 2.0f, 0};
  for_each_world_position(objects,
                          [&](glm::vec3 p) { sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre)); });
  if (!std::isfinite(sphere.radius) || !(sphere.radius > 0))
    throw Error(ErrorKind::bad_input, "scene", "bounds",
                fmt::format("the scene's radius is {} m; check positions, scales and units", sphere.radius));
  return sphere;
}

void fit_depth(View& view, const BoundingSphere& bounds) {
  const float distance = glm::distance(view.eye, bounds.centre);
  // Depth is measured along the view's axis: the corner of a picture twice as wide as high is nearer by this cosine.
  const float half_height = std::tan(glm::radians(view.fov_y_degrees) / 2);
  const float corner_cosine = 1 / std::sqrt(1 + 5 * half_height * half_height);
  view.near_m = std::max(0.01f * bounds.radius, 0.95f * (distance - bounds.radius) * corner_cosine);
  view.far_m = 1.05f * (distance + bounds.radius);
}

std::vector<View> default_views(const std::vector<Object>& objects) {
  const BoundingSphere bounds = bounding_sphere(objects);
  glm::vec3 touched = bounds.centre;
  float furthest = -INFINITY;
  for_each_world_position(objects, [&](glm::vec3 p) {
    const float along = glm::dot(p - bounds.centre, grazing_side);
    if (along > furthest) furthest = along, touched = p;
  });
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), grazing_side));
  View grazing;
  grazing.name = "grazing";
  grazing.fov_y_degrees = fov_y_degrees;
  grazing.eye = touched + bounds.radius * (grazing_height * grazing_side - grazing_distance * across);
  grazing.target = touched;
  grazing.up = grazing_side;
  fit_depth(grazing, bounds);
  return {seen_from("front", bounds, {0, 0, 1}), seen_from("three_quarter", bounds, {0.75f, 0.45f, 0.9f}), grazing};
}

std::vector<Light> default_lights(const BoundingSphere& bounds) {
  // Key, fill and ambient together bring white to about 1, where a display ends: errors in clipped pixels do not show.
  Light key{"key", Light::Kind::directional, glm::normalize(glm::vec3(-0.5f, -0.7f, -0.6f)), {}, {1.1f, 1.05f, 0.96f}};
  Light fill{"fill", Light::Kind::directional, glm::normalize(glm::vec3(0.8f, -0.1f, -0.5f)), {}, {0.20f, 0.25f, 0.32f}};
  Light rim{"rim", Light::Kind::point, {0, -1, 0}, {}, {}};
  const glm::vec3 offset = bounds.radius * glm::vec3(-1.2f, 1.1f, -1.6f);
  rim.position = bounds.centre + offset;
  // Irradiance 0.9 at the centre, before the square of the distance takes its share.
  rim.radiance = 0.9f * glm::vec3(1.0f, 0.95f, 0.9f) * glm::dot(offset, offset);
  key.casts = true;
  return {key, fill, rim};
}

}  // namespace lamina
