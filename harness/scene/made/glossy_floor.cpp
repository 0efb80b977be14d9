// SPDX-License-Identifier: Apache-2.0
// See glossy_floor.h.
#include "harness/scene/made/glossy_floor.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/tiles.h"

namespace lamina {
namespace {

Object floor_strip(std::string name, float left, float roughness) {
  Object strip = coloured_object(std::move(name), upright_square(), {0.035f, 0.032f, 0.03f}, false);
  strip.world_from_object =
      glm::scale(glm::rotate(glm::translate(glm::mat4(1), {left + 0.5f, 0, 0.7f}), glm::radians(-90.0f), glm::vec3(1, 0, 0)),
                 {1, 4.6f, 1});
  strip.said.calls.insert("glossy_reflection");
  strip.said.values["glossy.roughness"] = {double(roughness)};
  strip.said.values["glossy.reflectance"] = {0.25};
  return strip;
}

Object column(std::string name, glm::vec2 at, float half_m, float height_m, glm::vec3 colour) {
  const Block block{{at.x - half_m, 0, at.y - half_m}, {at.x + half_m, height_m, at.y + half_m}};
  return coloured_object(std::move(name), block_mesh({block}, 1), colour, false);
}

}  // namespace

Scene make_glossy_floor() {
  Scene scene;
  scene.objects.push_back(floor_strip("floor_0", -2, 0));
  scene.objects.push_back(floor_strip("floor_1", -1, 0.18f));
  scene.objects.push_back(floor_strip("floor_2", 0, 0.3f));
  scene.objects.push_back(floor_strip("floor_3", 1, 0.45f));
  Object wall = tiled_object("wall", upright_square(), {12, 6}, 3);
  wall.world_from_object = glm::scale(glm::translate(glm::mat4(1), {0, 1.0f, -1.6f}), {4, 2, 1});
  scene.objects.push_back(std::move(wall));
  scene.objects.push_back(column("column_0", {-1.45f, -0.55f}, 0.09f, 0.95f, {0.80f, 0.78f, 0.72f}));
  scene.objects.push_back(column("column_1", {-0.6f, -0.75f}, 0.12f, 0.75f, {0.75f, 0.12f, 0.08f}));
  scene.objects.push_back(column("column_2", {0.42f, -0.5f}, 0.08f, 0.9f, {0.82f, 0.62f, 0.10f}));
  scene.objects.push_back(column("column_3", {1.5f, -0.65f}, 0.11f, 0.85f, {0.10f, 0.32f, 0.72f}));
  scene.objects.push_back(coloured_ball("ball_0", {-1.05f, 0.34f, 0.05f}, 0.17f, {0.12f, 0.55f, 0.20f}));
  scene.objects.push_back(coloured_ball("ball_1", {0.0f, 0.18f, 0.25f}, 0.18f, {0.85f, 0.83f, 0.80f}));
  scene.objects.push_back(coloured_ball("ball_2", {1.0f, 0.45f, 0.0f}, 0.2f, {0.75f, 0.20f, 0.45f}));
  scene.lights.push_back(directional_light("key", glm::normalize(glm::vec3(-0.5f, 0.8f, 0.75f)), {0.95f, 0.9f, 0.82f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.8f, 0.45f, 0.4f)), {0.22f, 0.25f, 0.3f}));
  scene.ambient = {0.22f, 0.23f, 0.25f};
  scene.background = {0.10f, 0.12f, 0.15f};
  scene.views = {{"front", {0, 0.75f, 3.4f}, {0, 0.28f, 0}, {0, 1, 0}, 36},
                 {"low", {0.9f, 0.32f, 2.9f}, {0.1f, 0.25f, -0.4f}, {0, 1, 0}, 36},
                 {"steep", {-0.4f, 2.6f, 2.2f}, {0, 0.1f, -0.2f}, {0, 1, 0}, 36}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
