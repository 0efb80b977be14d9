// SPDX-License-Identifier: Apache-2.0
// See open_plane.h.
#include "harness/scene/made/open_plane.h"

#include <cmath>

#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"

namespace lamina {
namespace {

constexpr uint32_t points = 17;
constexpr float half_m = 2;

Mesh plane() {
  Mesh mesh;
  add_grid(mesh, points, points, [](uint32_t column, uint32_t row) {
    const glm::vec2 t = glm::vec2(column, row) / static_cast<float>(points - 1);
    const glm::vec2 p = half_m * (2.0f * t - 1.0f);
    return height_vertex({p.x, 0, p.y}, {0, 0}, t);
  });
  return mesh;
}

}  // namespace

Scene make_open_plane() {
  Scene scene;
  scene.objects.push_back(coloured_object("plane", plane(), {0.5f, 0.5f, 0.5f}, true));
  const float elevation = glm::radians(40.0f);
  scene.lights.push_back(
      directional_light("sun", {std::cos(elevation), std::sin(elevation), 0}, glm::vec3(1), glm::radians(10.0f)));
  scene.ambient = {0.2f, 0.2f, 0.2f};
  scene.background = {0.1f, 0.1f, 0.1f};
  scene.views = {{"front", {0, 2.4f, 4}, {0, 0, 0.1f}, {0, 1, 0}, 40, 0.1f, 12},
                 {"above", {0, 6, 0}, {0, 0, 0}, {0, 0, -1}, 40, 0.1f, 12}};
  return scene;
}

}  // namespace lamina
