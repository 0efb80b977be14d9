// SPDX-License-Identifier: Apache-2.0
// See glass_stack.h.
#include "harness/scene/made/glass_stack.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/transparent_object.h"

namespace lamina {
namespace {

Mesh pane(float width, float height) { return block_mesh({{{-width / 2, 0, -0.008f}, {width / 2, height, 0.008f}}}, 10); }

glm::mat4 placed(glm::vec3 at, float turn_degrees = 0) {
  return glm::rotate(glm::translate(glm::mat4(1), at), glm::radians(turn_degrees), {0, 1, 0});
}

}  // namespace

void add_striped_room(Scene& scene) {
  std::vector<Block> dark, light;
  for (int i = 0; i < 11; ++i) {
    const float left = -1.1f + 0.2f * static_cast<float>(i);
    (i % 2 == 0 ? dark : light).push_back({{left, 0, -1.2f}, {left + 0.2f, 1.3f, -1.1f}});
  }
  scene.objects.push_back(
      coloured_object("table", block_mesh({{{-1.6f, -0.1f, -1.2f}, {1.6f, 0, 0.9f}}}, 10), {0.34f, 0.24f, 0.16f}, false));
  scene.objects.push_back(coloured_object("dark_stripes", block_mesh(dark, 10), {0.10f, 0.12f, 0.15f}, false));
  scene.objects.push_back(coloured_object("light_stripes", block_mesh(light, 10), {0.82f, 0.80f, 0.74f}, false));
  scene.lights.push_back(directional_light("window", glm::normalize(glm::vec3(-0.55f, 0.75f, 0.6f)), {1.05f, 1.0f, 0.92f}));
  scene.lights.push_back(directional_light("sky", glm::normalize(glm::vec3(0.8f, 0.35f, 0.55f)), {0.22f, 0.27f, 0.34f}));
  scene.ambient = {0.16f, 0.18f, 0.21f};
  scene.background = {0.30f, 0.34f, 0.38f};
}

Scene make_glass_stack() {
  Scene scene;
  add_striped_room(scene);
  scene.objects.push_back(coloured_object("stone", sphere_mesh(), {0.55f, 0.22f, 0.08f}, false));
  scene.objects.back().world_from_object = glm::scale(placed({-0.12f, 0.17f, -0.45f}), glm::vec3(0.17f));
  const auto glass = [&](std::string name, Mesh mesh, const glm::mat4& place, const GlassLook& look) {
    scene.objects.push_back(transparent_object(std::move(name), std::move(mesh), look));
    scene.objects.back().world_from_object = place;
  };
  glass("blue_pane", pane(0.8f, 0.95f), placed({0.30f, 0, -0.62f}, 14), {{0.10f, 0.26f, 0.62f}, 0.22, 0.8});
  glass("green_pane", pane(0.7f, 0.80f), placed({0.02f, 0, -0.20f}, -9), {{0.10f, 0.50f, 0.28f}, 0.20, 0.8});
  glass("red_pane", pane(0.62f, 0.66f), placed({-0.30f, 0, 0.12f}, 22), {{0.68f, 0.10f, 0.08f}, 0.22, 0.8});
  glass("ball", sphere_mesh(), glm::scale(placed({0.40f, 0.2f, 0.18f}), glm::vec3(0.2f)), {{0.72f, 0.86f, 0.88f}, 0.07, 4});
  glass("bowl", shell_mesh(0.94f), glm::scale(placed({0.02f, 0.14f, 0.45f}), glm::vec3(0.2f, 0.14f, 0.2f)),
        {{0.86f, 0.74f, 0.42f}, 0.05, 3});
  scene.views = {{"front", {0.05f, 0.62f, 2.35f}, {0.03f, 0.38f, -0.2f}, {0, 1, 0}, 34},
                 {"along", {-1.65f, 0.50f, 1.1f}, {0.05f, 0.34f, -0.15f}, {0, 1, 0}, 36},
                 {"edges", {0.14f, 0.60f, 1.0f}, {0.10f, 0.50f, -0.4f}, {0, 1, 0}, 30}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
