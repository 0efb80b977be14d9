// SPDX-License-Identifier: Apache-2.0
// See open_sea.h.
#include "harness/scene/made/open_sea.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sky_dome.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/water_grid.h"

namespace lamina {
Scene make_open_sea(float) {
  Scene scene;
  scene.ambient = {0.40f, 0.45f, 0.54f};
  constexpr float spacing_m = 0.35f, growth = 0.04f, horizon_m = 2500;
  scene.objects.push_back(water_object(scene, water_disc(horizon_m, spacing_m, growth), spacing_m, growth));
  Object rock = coloured_object("rock", sphere_mesh(25), {0.20f, 0.17f, 0.14f}, false);
  rock.world_from_object = glm::scale(glm::translate(glm::mat4(1), {-14, -1, -48}), {11, 5, 7});
  scene.objects.push_back(std::move(rock));
  scene.objects.push_back(
      coloured_object("tower", block_mesh({{{-15.2f, 2, -49.2f}, {-12.8f, 14, -46.8f}}}, 4), {0.80f, 0.78f, 0.74f}, false));
  scene.objects.push_back(coloured_ball("lamp", {-14, 14.6f, -48}, 1.5f, {0.70f, 0.12f, 0.08f}));
  scene.objects.push_back(coloured_ball("buoy_0", {3.2f, 0.35f, -13}, 0.9f, {0.75f, 0.10f, 0.06f}));
  scene.objects.push_back(coloured_ball("buoy_1", {9, 0.3f, -27}, 0.9f, {0.10f, 0.50f, 0.18f}));
  scene.lights.push_back(
      directional_light("sun", glm::normalize(glm::vec3(0.34f, 0.27f, -0.9f)), {1.2f, 0.98f, 0.72f}, 0.0046f));
  scene.background = {0.40f, 0.44f, 0.52f};
  add_sky_dome(scene, {{0.40f, 0.43f, 0.48f}, {0.30f, 0.38f, 0.52f}, {0.14f, 0.24f, 0.46f}}, horizon_m, -5);
  set_wave(scene, 1, {0.42, 26, -80, 0.20});
  set_wave(scene, 2, {0.20, 13, -115, 0.16});
  set_wave(scene, 3, {0.09, 6.1, -55, 0.14});
  set_wave(scene, 4, {0.035, 2.9, -95, 0.10});
  auto& values = scene.said["water"].values;
  values["grid_follows"] = {1.0};
  values["caustics"] = {0.0};
  values["foam"] = {0.9};
  values["foam_height"] = {0.36};
  values["foam_size"] = {6.0};
  values["specular"] = {0.12};
  scene.views = {{"horizon", {0, 2.6f, 6}, {0.6f, 1.2f, -14}, {0, 1, 0}, 45, 0.2f, 6000},
                 {"high", {-6, 16, 14}, {0, 0, -18}, {0, 1, 0}, 45, 0.5f, 6000},
                 {"low", {2, 1.0f, -3}, {2.4f, 0.9f, -14}, {0, 1, 0}, 40, 0.1f, 6000}};
  return scene;
}

}  // namespace lamina
