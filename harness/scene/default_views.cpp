// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/default_views.h"

#include <algorithm>
#include <array>
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

View seen_from(std::string name, const BoundingSphere& bounds, glm::vec3 direction, glm::vec3 up) {
  View view;
  view.name = std::move(name);
  view.fov_y_degrees = fov_y_degrees;
  // The cone of view touches the sphere where sin(fov / 2) = radius / distance.
  const float distance = margin * bounds.radius / std::sin(glm::radians(fov_y_degrees) / 2);
  view.eye = bounds.centre + distance * glm::normalize(direction);
  view.target = bounds.centre;
  view.up = up;
  fit_depth(view, bounds);
  return view;
}

const std::array<glm::vec3, 3> view_sides = {glm::vec3(0, 0, 1), glm::vec3(0.75f, 0.45f, 0.9f), grazing_side};

// What turns the directions of views so that they meet the side that is drawn. The identity, unless nearly all surfaces face
// one way (a leaf, a relief), and that way is away from every view: then "front" looks at that side.
glm::mat3 world_from_sides(const std::vector<Object>& objects) {
  constexpr float one_way = 0.5f;  // of the sum of areas: the length of the sum of area vectors, 0 for closed surfaces
  constexpr float seen = 0.05f;    // cosine
  glm::vec3 sum(0);
  float area = 0;
  for (const Object& object : objects)
    for (size_t i = 0; i + 2 < object.mesh.indices.size(); i += 3) {
      const auto corner = [&](size_t k) {
        return glm::vec3(object.world_from_object * glm::vec4(object.mesh.vertices[object.mesh.indices[i + k]].position, 1));
      };
      const glm::vec3 doubled = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
      sum += doubled, area += glm::length(doubled);
    }
  const float length = glm::length(sum);
  if (!(length > one_way * area)) return glm::mat3(1);
  const glm::vec3 faces = sum / length;
  if (std::ranges::any_of(view_sides, [&](const glm::vec3& side) { return glm::dot(glm::normalize(side), faces) > seen; }))
    return glm::mat3(1);
  const glm::vec3 up = std::abs(faces.y) > 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(up, faces));
  return {right, glm::cross(faces, right), faces};
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
  const glm::mat3 turned = world_from_sides(objects);
  const glm::vec3 side = turned * grazing_side;
  glm::vec3 touched = bounds.centre;
  float furthest = -INFINITY;
  for_each_world_position(objects, [&](glm::vec3 p) {
    const float along = glm::dot(p - bounds.centre, side);
    if (along > furthest) furthest = along, touched = p;
  });
  const glm::vec3 across = glm::normalize(glm::cross(turned * glm::vec3(0, 1, 0), side));
  View grazing;
  grazing.name = "grazing";
  grazing.fov_y_degrees = fov_y_degrees;
  grazing.eye = touched + bounds.radius * (grazing_height * side - grazing_distance * across);
  grazing.target = touched;
  grazing.up = side;
  fit_depth(grazing, bounds);
  return {seen_from("front", bounds, turned * view_sides[0], turned[1]),
          seen_from("three_quarter", bounds, turned * view_sides[1], turned[1]), grazing};
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
