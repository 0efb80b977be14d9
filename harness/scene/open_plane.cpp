// SPDX-License-Identifier: Apache-2.0
// See open_plane.h.
#include "harness/scene/open_plane.h"

#include <cmath>

#include "harness/scene/coloured_object.h"
#include "harness/scene/height_field.h"

namespace lamina {
namespace {

constexpr uint32_t points = 17;
constexpr float half_m = 2;

Mesh plane() {
  Mesh mesh;
  for (uint32_t row = 0; row < points; ++row)
    for (uint32_t column = 0; column < points; ++column) {
      const glm::vec2 t = glm::vec2(column, row) / static_cast<float>(points - 1);
      const glm::vec2 p = half_m * (2.0f * t - 1.0f);
      mesh.vertices.push_back(height_vertex({p.x, 0, p.y}, {0, 0}, t));
    }
  add_grid_triangles(mesh, 0, points, points);
  return mesh;
}

}  // namespace

Scene make_open_plane() {
  Scene scene;
  scene.objects.push_back(coloured_object("plane", plane(), {0.5f, 0.5f, 0.5f}, true));
  Light sun;
  sun.name = "sun";
  const float elevation = glm::radians(40.0f);
  sun.direction = -glm::vec3(std::cos(elevation), std::sin(elevation), 0);
  sun.radiance = glm::vec3(1);
  sun.angular_radius = glm::radians(10.0f);
  scene.lights.push_back(sun);
  scene.ambient = {0.2f, 0.2f, 0.2f};
  scene.background = {0.1f, 0.1f, 0.1f};
  scene.views = {{"front", {0, 2.4f, 4}, {0, 0, 0.1f}, {0, 1, 0}, 40, 0.1f, 12},
                 {"above", {0, 6, 0}, {0, 0, 0}, {0, 0, -1}, 40, 0.1f, 12}};
  return scene;
}

}  // namespace lamina
