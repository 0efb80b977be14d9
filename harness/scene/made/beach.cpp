// SPDX-License-Identifier: Apache-2.0
// See beach.h.
#include "harness/scene/made/beach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/made/sky_dome.h"
#include "harness/scene/made/water_grid.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr float deepest_m = 5, far_m = 260, map_m = 96;

// The sand's height over still water: the sea lies towards -z.
float sand_height(float x, float z) {
  const float shore = z + 2.2f * std::sin(0.13f * x) + 0.8f * std::sin(0.37f * x + 1);
  return std::clamp(0.09f * shore + 0.05f * fractal_noise({0.35f * x, 0, 0.35f * z}, 3, 8), -deepest_m, 2.5f);
}

Object sand() {
  // Fine along the shore, coarse towards the sea.
  constexpr uint32_t columns = 121, rows = 121;
  const auto spread = [](float t) { return std::copysign(0.35f * std::abs(t) + 0.65f * std::pow(std::abs(t), 4.0f), t); };
  Mesh mesh;
  add_grid(mesh, columns, rows, [&](uint32_t column, uint32_t row) {
    const glm::vec2 uv = glm::vec2(column, row) / glm::vec2(columns - 1, rows - 1);
    const float x = far_m * spread(2 * uv.x - 1), z = far_m * spread(2 * uv.y - 1);
    constexpr float step = 0.05f;
    return height_vertex({x, sand_height(x, z), z},
                         {(sand_height(x + step, z) - sand_height(x - step, z)) / (2 * step),
                          (sand_height(x, z + step) - sand_height(x, z - step)) / (2 * step)},
                         uv);
  });
  constexpr uint32_t side = 512;
  Texels grains{side, side, {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const float light = 1 + 0.3f * fractal_noise({0.11f * static_cast<float>(x), 0, 0.11f * static_cast<float>(y)}, 4, 3);
      grains.rgba.emplace_back(glm::vec3(0.50f, 0.42f, 0.30f) * light, 1);
    }
  Object object = coloured_object("sand", std::move(mesh), glm::vec3(1), false);
  object.said.values["albedo"] = {make_texture("sand", grains, TexelMeaning::colour)};
  return object;
}

// The depth of the bottom over map_m around the middle; white is the deepest.
Texture bottom_map() {
  constexpr uint32_t side = 256;
  Texels depth{side, side, {}};
  for (uint32_t row = 0; row < side; ++row)
    for (uint32_t column = 0; column < side; ++column) {
      const glm::vec2 at = ((glm::vec2(column, row) + 0.5f) / float(side) - 0.5f) * map_m;
      depth.rgba.emplace_back(glm::vec3(std::clamp(-sand_height(at.x, at.y) / deepest_m, 0.0f, 1.0f)), 1);
    }
  return make_texture("bottom", depth, TexelMeaning::data);
}

}  // namespace

Scene make_beach(float) {
  Scene scene;
  scene.ambient = {0.42f, 0.47f, 0.55f};
  constexpr float spacing_m = 0.22f, growth = 0.045f;
  scene.objects.push_back(water_object(scene, water_disc(far_m, spacing_m, growth), spacing_m, growth));
  scene.objects.push_back(sand());
  constexpr glm::vec3 rocks[] = {{-3.2f, 0.05f, -6.5f}, {-4.5f, 0.1f, -8.2f}, {4.6f, -0.1f, -9.5f}, {1.2f, -0.15f, -2.6f}};
  constexpr glm::vec3 sizes[] = {{1.3f, 0.8f, 1.0f}, {0.9f, 0.9f, 0.8f}, {1.8f, 1.1f, 1.3f}, {0.5f, 0.32f, 0.4f}};
  for (int i = 0; i < 4; ++i) {
    Object rock = coloured_ball(fmt::format("rock_{}", i), rocks[i], 1, {0.23f, 0.20f, 0.17f});
    rock.world_from_object =
        glm::scale(glm::rotate(glm::translate(glm::mat4(1), rocks[i]), 0.7f * float(i), glm::vec3(0.2f, 1, 0)), sizes[i]);
    scene.objects.push_back(std::move(rock));
  }
  for (int i = 0; i < 3; ++i) {
    const glm::vec2 at(1.6f + 0.9f * float(i), -5.2f - 1.7f * float(i));
    const Block post{{at.x - 0.11f, -2.0f, at.y - 0.11f}, {at.x + 0.11f, 0.95f, at.y + 0.11f}};
    scene.objects.push_back(coloured_object(fmt::format("post_{}", i), block_mesh({post}, 3), {0.36f, 0.25f, 0.16f}, false));
  }
  scene.lights.push_back(
      directional_light("sun", glm::normalize(glm::vec3(-0.7f, 0.5f, -0.25f)), {1.1f, 0.96f, 0.78f}, 0.0046f));
  scene.background = {0.42f, 0.47f, 0.55f};
  add_sky_dome(scene, {{0.41f, 0.46f, 0.53f}, {0.31f, 0.40f, 0.54f}, {0.16f, 0.27f, 0.48f}}, far_m, -4);
  set_wave(scene, 1, {0.09, 6.5, -85, 0.16});
  set_wave(scene, 2, {0.045, 3.7, -120, 0.12});
  set_wave(scene, 3, {0.02, 2.1, -60, 0.10});
  set_wave(scene, 4, {0.010, 1.2, -95, 0.08});
  auto& values = scene.said["water"].values;
  values["bottom"] = {bottom_map()};
  values["bottom_depth"] = {double(deepest_m)};
  values["bottom_width"] = {double(map_m)};
  values["ripples"] = {0.05};
  values["foam"] = {0.9};
  values["foam_height"] = {0.1};
  values["foam_depth"] = {0.14};
  values["foam_size"] = {1.6};
  values["soft_edge"] = {0.35};
  values["specular"] = {0.25};
  values["scattering"] = {2.0};
  values["caustics"] = {0.8};
  scene.views = {{"shore", {-1.5f, 2.1f, 5.5f}, {0.2f, -0.2f, -4.5f}, {0, 1, 0}, 48, 0.1f, 700},
                 {"along", {7.5f, 0.9f, -1.0f}, {-2, 0.1f, -5.5f}, {0, 1, 0}, 46, 0.1f, 700},
                 {"above", {0.5f, 9, 2.5f}, {0.4f, -1, -5.0f}, {0, 1, 0}, 46, 0.3f, 700}};
  return scene;
}

}  // namespace lamina
