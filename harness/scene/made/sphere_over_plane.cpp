// SPDX-License-Identifier: Apache-2.0
// See sphere_over_plane.h.
#include "harness/scene/made/sphere_over_plane.h"

#include "harness/scene/default_views.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/sphere_mesh.h"

namespace lamina {
namespace {

constexpr float centre_m = 1.15f;  // the sphere's, above the plane: a gap of 0.15 m
constexpr uint32_t plane_points = 193;
constexpr float plane_half_m = 40;

// A grid whose points crowd in the middle: 4 cm apart under the sphere, metres at the horizon.
Mesh ground() {
  const auto place = [](uint32_t i) {
    const float t = 2 * static_cast<float>(i) / (plane_points - 1) - 1;
    return plane_half_m * (0.1f * t + 0.9f * t * t * t * t * t);
  };
  Mesh mesh;
  add_grid(mesh, plane_points, plane_points, [&](uint32_t column, uint32_t row) {
    const glm::vec2 uv = (glm::vec2(column, row) + 0.5f) / static_cast<float>(plane_points);
    return height_vertex({place(column), 0, place(row)}, {0, 0}, uv);
  });
  return mesh;
}

}  // namespace

Scene make_sphere_over_plane() {
  Scene scene;
  scene.objects.push_back(coloured_object("plane", ground(), {0.46f, 0.44f, 0.41f}, true));
  scene.objects.push_back(coloured_object("sphere", sphere_mesh(), {0.62f, 0.34f, 0.22f}, true));
  scene.objects[1].world_from_object[3] = glm::vec4(0, centre_m, 0, 1);
  const glm::vec3 to_sun = glm::normalize(glm::vec3(-0.8f, 1, 0.6f));  // 45 degrees above the horizon
  scene.lights.push_back(directional_light("sun", to_sun, {1.15f, 1.08f, 0.98f}, glm::radians(10.0f)));
  scene.ambient = {0.26f, 0.30f, 0.36f};
  scene.background = {0.42f, 0.50f, 0.60f};
  scene.views = {{"front", {0.6f, 2.6f, 7.5f}, {0.35f, 0.75f, 0}, {0, 1, 0}, 36},
                 {"under", {2.0f, 0.30f, 4.3f}, {0.2f, 0.55f, 0}, {0, 1, 0}, 40},
                 {"above", {0, 9, 2.5f}, {0.4f, 0, -0.3f}, {0, 0, -1}, 40}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) {
    fit_depth(view, bounds);
    view.near_m = 0.1f;  // the plane is large and the sphere near
  }
  return scene;
}

}  // namespace lamina
