// SPDX-License-Identifier: Apache-2.0
// See fog_xray.h.
#include "harness/scene/made/fog_xray.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/mesh/tangents.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr float film_length_m = 0.2f;

// A ring around y. The last column and row stand exactly at the first.
Mesh torus(float radius, float thickness) {
  constexpr uint32_t around = 48, across = 20;
  Mesh mesh;
  add_grid(mesh, around + 1, across + 1, [&](uint32_t column, uint32_t row) -> Vertex {
    const float a = 2 * static_cast<float>(M_PI) * static_cast<float>(column % around) / around;
    const float b = -2 * static_cast<float>(M_PI) * static_cast<float>(row % across) / across;
    const glm::vec3 out(std::cos(a), 0, -std::sin(a));
    const glm::vec3 normal = std::cos(b) * out + glm::vec3(0, std::sin(b), 0);
    return {radius * out + thickness * normal, normal, glm::vec4(0), {float(column) / around, float(row) / across}};
  });
  compute_tangents(mesh);
  return mesh;
}

// Thin things orange, thicker ones green, then blue, then nearly black; the film itself lets all light through.
std::shared_ptr<const TextureImage> film() {
  constexpr uint32_t texels = 256;
  constexpr glm::vec3 stops[] = {{0.95f, 0.52f, 0.10f}, {0.80f, 0.38f, 0.05f}, {0.16f, 0.42f, 0.10f},
                                 {0.04f, 0.16f, 0.45f}, {0.01f, 0.05f, 0.20f}, {0.004f, 0.006f, 0.03f}};
  Texels ramp{texels, 1, {}};
  for (uint32_t i = 0; i < texels; ++i) {
    const float t = static_cast<float>(i) / (texels - 1), at = 5 * t;
    const auto stop = std::min(static_cast<uint32_t>(at), 4u);
    ramp.rgba.emplace_back(glm::mix(stops[stop], stops[stop + 1], at - static_cast<float>(stop)), 1 - std::exp(-9 * t));
  }
  return make_texture("film", ramp, TexelMeaning::colour);
}

}  // namespace

Scene make_fog_xray(float time_s) {
  Scene scene;
  const auto add = [&](Object object, const glm::mat4& place) {
    object.world_from_object = place * object.world_from_object;
    scene.objects.push_back(std::move(object));
  };
  const glm::mat4 turned = glm::rotate(glm::mat4(1), 2 * static_cast<float>(M_PI) * time_s / 12, glm::vec3(0, 1, 0));
  const auto at = [&](glm::vec3 place, float degrees, glm::vec3 axis) {
    return glm::rotate(glm::translate(turned, place), glm::radians(degrees), axis);
  };
  constexpr glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  add(fog_box("case", {-0.50f, -0.34f, -0.15f}, {0.50f, 0.34f, 0.15f}, 0.5f), turned);
  add(fog_box("inside", {-0.48f, -0.32f, -0.13f}, {0.48f, 0.32f, 0.13f}, 0.5f, true), turned);
  add(fog_box("handle", {-0.12f, 0.34f, -0.02f}, {0.12f, 0.42f, 0.02f}, 1), turned);
  add(fog_box("grip", {-0.09f, 0.34f, -0.02f}, {0.09f, 0.39f, 0.02f}, 1, true), turned);
  add(fog_ball("bottle", {0, 0, 0}, {0.085f, 0.19f, 0.085f}, 0.9f), at({-0.32f, -0.08f, 0}, 12, z));
  add(fog_ball("bubble", {0, 0, 0}, {0.05f, 0.04f, 0.05f}, 0.9f), at({-0.35f, 0.05f, 0}, 12, z));
  scene.objects.back().said.values["fog.volume"] = {std::string("hole")};
  add(fog_hull("ring", torus(0.11f, 0.028f), glm::mat4(1), 1), at({0.02f, 0.13f, 0.02f}, 78, x));
  add(fog_hull("bracelet", torus(0.07f, 0.016f), glm::mat4(1), 1), at({0.08f, 0.02f, -0.04f}, 60, x));
  add(fog_box("book", {-0.13f, -0.09f, -0.025f}, {0.13f, 0.09f, 0.025f}, 0.6f), at({0.05f, -0.19f, 0.05f}, 8, z));
  add(fog_box("phone", {-0.04f, -0.075f, -0.006f}, {0.04f, 0.075f, 0.006f}, 1), at({0.33f, -0.16f, -0.02f}, -24, z));
  add(fog_box("wrench", {-0.015f, -0.17f, -0.012f}, {0.015f, 0.17f, 0.012f}, 1), at({0.33f, 0.09f, 0.03f}, -38, z));
  add(fog_hull("jaw", torus(0.035f, 0.014f), glm::mat4(1), 1), at({0.435f, 0.222f, 0.03f}, 90, x));
  add(fog_ball("fruit", {0, 0, 0}, {0.07f, 0.065f, 0.07f}, 0.8f), at({-0.13f, 0.21f, -0.03f}, 0, y));
  set_fog(scene, 1, {0, 0, 0});
  Keys& said = scene.said["volume_fog"];
  const auto ramp = film();
  said.values["ramp"] = said.values["ramp_opacity"] = {ramp};
  said.values["ramp_length"] = {double(film_length_m)};
  scene.lights.push_back(directional_light("lamp", {0, 0, 1}, {1, 1, 1}));
  scene.background = {0.86f, 0.87f, 0.88f};
  scene.views = {{"front", {0, 0.02f, 2.2f}, {0, 0.02f, 0}, {0, 1, 0}, 30, 0.1f, 5},
                 {"corner", {1.1f, 0.8f, 1.6f}, {0, 0, 0}, {0, 1, 0}, 34, 0.1f, 5}};
  scene.lights_move = scene.mesh_moves = true;
  return scene;
}

}  // namespace lamina
