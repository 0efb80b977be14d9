// SPDX-License-Identifier: Apache-2.0
// See pool.h.
#include "harness/scene/made/pool.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sky_dome.h"
#include "harness/scene/made/tiles.h"
#include "harness/scene/made/water_grid.h"

namespace lamina {
namespace {

constexpr float half_long_m = 3, half_wide_m = 2, deep_m = 1.5f, deck_m = 0.15f;
constexpr float lining_m = 0.01f;  // tiles before the deck's own faces

// A tiled square, turned about x (to the floor) or y (to the sides), of this size in metres.
Object tiled_side(std::string name, glm::vec3 middle, glm::vec3 axis, float degrees, glm::vec2 size, glm::uvec2 tiles,
                  uint32_t seed) {
  Object side = tiled_object(std::move(name), upright_square(), tiles, seed);
  side.world_from_object =
      glm::scale(glm::rotate(glm::translate(glm::mat4(1), middle), glm::radians(degrees), axis), {size.x, size.y, 1});
  return side;
}

Object standing_block(std::string name, glm::vec3 low, glm::vec3 high, glm::vec3 colour) {
  return coloured_object(std::move(name), block_mesh({{low, high}}, 2), colour, false);
}

}  // namespace

Scene make_pool(float) {
  Scene scene;
  scene.ambient = {0.42f, 0.48f, 0.58f};
  constexpr float spacing_m = 0.06f;
  scene.objects.push_back(water_object(
      scene,
      water_rectangle({-half_long_m - 0.05f, -half_wide_m - 0.05f}, {half_long_m + 0.05f, half_wide_m + 0.05f}, spacing_m),
      spacing_m, 0));
  const float x = half_long_m - lining_m, z = half_wide_m - lining_m, high = deep_m + deck_m, middle = (deck_m - deep_m) / 2;
  scene.objects.push_back(tiled_side("floor", {0, -deep_m + lining_m, 0}, {1, 0, 0}, -90, {6, 4}, {12, 8}, 11));
  scene.objects.push_back(tiled_side("end_0", {-x, middle, 0}, {0, 1, 0}, 90, {4, high}, {8, 3}, 12));
  scene.objects.push_back(tiled_side("end_1", {x, middle, 0}, {0, 1, 0}, -90, {4, high}, {8, 3}, 13));
  scene.objects.push_back(tiled_side("side_0", {0, middle, -z}, {0, 1, 0}, 0, {6, high}, {12, 3}, 14));
  scene.objects.push_back(tiled_side("side_1", {0, middle, z}, {0, 1, 0}, 180, {6, high}, {12, 3}, 15));
  const Block deck{{-5, -1.8f, -3.6f}, {5, deck_m, 4}},
      hole{{-half_long_m, -deep_m, -half_wide_m}, {half_long_m, deck_m + 0.1f, half_wide_m}, false};
  scene.objects.push_back(coloured_object("deck", block_mesh({deck, hole}, 2), {0.52f, 0.49f, 0.44f}, false));
  Object wall = tiled_object("wall", upright_square(), {10, 2}, 6);
  wall.world_from_object = glm::scale(glm::translate(glm::mat4(1), {0, 0.9f + deck_m, -3.4f}), {9, 1.8f, 1});
  scene.objects.push_back(std::move(wall));
  scene.objects.push_back(standing_block("post_0", {-2.5f, -1.3f, -1.75f}, {-2.42f, 0.75f, -1.67f}, {0.75f, 0.76f, 0.78f}));
  scene.objects.push_back(standing_block("post_1", {-2.0f, -1.3f, -1.75f}, {-1.92f, 0.75f, -1.67f}, {0.75f, 0.76f, 0.78f}));
  scene.objects.push_back(standing_block("column_0", {-1.2f, deck_m, -2.6f}, {-0.9f, 1.6f, -2.3f}, {0.80f, 0.78f, 0.72f}));
  scene.objects.push_back(standing_block("column_1", {0.5f, deck_m, -2.6f}, {0.8f, 1.3f, -2.3f}, {0.72f, 0.14f, 0.09f}));
  scene.objects.push_back(standing_block("column_2", {2.1f, deck_m, -2.6f}, {2.4f, 1.7f, -2.3f}, {0.12f, 0.32f, 0.66f}));
  scene.objects.push_back(coloured_ball("ball_0", {0.9f, 0.08f, -0.6f}, 0.26f, {0.80f, 0.12f, 0.08f}));
  scene.objects.push_back(coloured_ball("ball_1", {-0.9f, 0.05f, 0.35f}, 0.18f, {0.85f, 0.70f, 0.10f}));
  scene.objects.push_back(coloured_ball("ball_2", {0.2f, -1.2f, 0.7f}, 0.28f, {0.80f, 0.80f, 0.78f}));
  scene.lights.push_back(
      directional_light("sun", glm::normalize(glm::vec3(-0.75f, 0.42f, 0.35f)), {1.05f, 0.92f, 0.74f}, 0.0046f));
  scene.background = {0.42f, 0.50f, 0.62f};
  add_sky_dome(scene, {{0.41f, 0.47f, 0.56f}, {0.30f, 0.40f, 0.56f}, {0.16f, 0.27f, 0.50f}}, 40, -2);
  set_wave(scene, 1, {0.012, 1.7, 25, 0.04});
  set_wave(scene, 2, {0.007, 1.05, 75, 0.04});
  set_wave(scene, 3, {0.004, 0.66, -30, 0.03});
  set_wave(scene, 4, {0.002, 0.42, 120, 0.03});
  auto& values = scene.said["water"].values;
  values["caustic_size"] = {2.2};
  values["caustics"] = {0.7};
  scene.views = {{"above", {0.3f, 3.6f, 4.2f}, {0, -0.5f, -0.1f}, {0, 1, 0}, 48, 0.2f, 120},
                 {"edge", {-2.6f, 1.25f, 3.0f}, {0.4f, -0.3f, -0.6f}, {0, 1, 0}, 50, 0.1f, 120},
                 {"grazing", {0.6f, 0.42f, 2.3f}, {-0.2f, 0.05f, -1.5f}, {0, 1, 0}, 46, 0.1f, 120}};
  return scene;
}

}  // namespace lamina
