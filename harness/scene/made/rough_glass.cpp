// SPDX-License-Identifier: Apache-2.0
// See rough_glass.h.
#include "harness/scene/made/rough_glass.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/tiles.h"

namespace lamina {
namespace {

Object glass_pane(std::string name, float left, float roughness, float thickness_m) {
  Object pane = coloured_object(std::move(name), upright_square(), glm::vec3(1), false);
  pane.world_from_object = glm::scale(glm::translate(glm::mat4(1), {left + 0.31f, 0.55f, 0}), {0.58f, 1.0f, 1});
  pane.said.calls.insert("rough_refraction");
  pane.said.values["rough_glass.roughness"] = {double(roughness)};
  pane.said.values["rough_glass.thickness"] = {double(thickness_m)};
  return pane;
}

}  // namespace

Scene make_rough_glass() {
  Scene scene;
  scene.objects.push_back(glass_pane("pane_0", -1.24f, 0.15f, 0.006f));
  scene.objects.push_back(glass_pane("pane_1", -0.62f, 0.3f, 0.006f));
  scene.objects.push_back(glass_pane("pane_2", 0.0f, 0.5f, 0.006f));
  scene.objects.push_back(glass_pane("pane_3", 0.62f, 0.3f, 0.12f));
  Object wall = tiled_object("wall", upright_square(), {14, 8}, 3), floor = tiled_object("floor", upright_square(), {9, 9}, 11);
  wall.world_from_object = glm::scale(glm::translate(glm::mat4(1), {0, 1.2f, -1.6f}), {4.9f, 2.8f, 1});
  floor.world_from_object = glm::scale(
      glm::rotate(glm::translate(glm::mat4(1), {0, 0, 0.2f}), glm::radians(-90.0f), glm::vec3(1, 0, 0)), {5, 3.7f, 1});
  scene.objects.push_back(std::move(wall));
  scene.objects.push_back(std::move(floor));
  scene.objects.push_back(coloured_ball("ball_0", {-0.85f, 0.30f, -0.35f}, 0.22f, {0.75f, 0.10f, 0.07f}));
  scene.objects.push_back(coloured_ball("ball_1", {-0.2f, 0.34f, -0.95f}, 0.26f, {0.85f, 0.62f, 0.08f}));
  scene.objects.push_back(coloured_ball("ball_2", {0.42f, 0.26f, -0.28f}, 0.18f, {0.10f, 0.28f, 0.75f}));
  scene.objects.push_back(coloured_ball("ball_3", {0.98f, 0.32f, -0.8f}, 0.24f, {0.10f, 0.55f, 0.18f}));
  scene.objects.push_back(
      coloured_object("rod", block_mesh({{{-0.36f, 0.0f, 0.24f}, {-0.33f, 0.95f, 0.27f}}}, 1), {0.02f, 0.02f, 0.025f}, false));
  scene.lights.push_back(directional_light("key", glm::normalize(glm::vec3(-0.4f, 0.9f, 0.75f)), {0.9f, 0.87f, 0.8f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.8f, 0.35f, 0.5f)), {0.18f, 0.2f, 0.24f}));
  scene.ambient = {0.22f, 0.23f, 0.25f};
  scene.background = {0.10f, 0.12f, 0.15f};
  scene.views = {{"front", {0, 0.85f, 3.7f}, {0, 0.5f, 0}, {0, 1, 0}, 36},
                 {"aslant", {1.9f, 1.0f, 2.4f}, {0.05f, 0.45f, -0.2f}, {0, 1, 0}, 36}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
