// SPDX-License-Identifier: Apache-2.0
// See layered_scenes.h. Colours are chosen by eye, in linear light.
#include "harness/scene/made/layered_scenes.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/heart.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/kept.h"
#include "harness/scene/made/marble.h"
#include "harness/scene/mesh/tangents.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

using Textures = std::vector<std::shared_ptr<const TextureImage>>;
constexpr uint32_t stack_texels = 512, lattice_texels = 512;

// A whitish film, thinner where the muscle below it is a window.
Texels membrane(const TextureImage& muscle) {
  Texels film = base_texels(muscle);
  for (glm::vec4& texel : film.rgba) {
    const float clear = texel.a;
    texel = glm::vec4(glm::mix(glm::vec3(0.62f, 0.44f, 0.40f), glm::vec3(texel), 0.25f), 0.70f + 0.24f * clear);
  }
  return film;
}

// Sheet `n` from 1: its colour, and transparency that follows its tone, so that clear seams wind through cloudy stone.
Texels sheet(uint32_t n) {
  static constexpr glm::vec3 tints[] = {{1.0f, 0.95f, 0.9f}, {0.75f, 0.9f, 1.0f}, {1.0f, 0.8f, 0.65f}, {0.7f, 1.0f, 0.85f}};
  Texels texels = marble(stack_texels, stack_texels, 10 * n);
  for (glm::vec4& texel : texels.rgba) {
    const float tone = (texel.r + texel.g + texel.b) / 3;
    texel =
        glm::vec4(glm::mix(glm::vec3(texel), glm::vec3(0.8f), 0.45f) * tints[n - 1], 1 - glm::smoothstep(0.08f, 0.42f, tone));
  }
  return texels;
}

Object stack_object(std::string name, Mesh mesh, const Textures& sheets) {
  Object object;
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  object.said.values = {{"albedo", {sheets[0]}},       {"outer.albedo", {sheets[0]}},       {"outer.transparency", {sheets[0]}},
                        {"inner.albedo", {sheets[1]}}, {"inner.transparency", {sheets[1]}}, {"thickness", {9.0}},
                        {"layer_count", {4.0}}};
  for (size_t n = 3; n <= 4; ++n) {
    const std::string layer = fmt::format("layer_{}.", n);
    object.said.values[layer + "albedo"] = {sheets[n - 1]};
    object.said.values[layer + "transparency"] = {sheets[n - 1]};
    object.said.values[layer + "distance"] = {9.0};
  }
  return object;
}

// Bars along both axes, eight a side, three eighths of a cell wide: transparency is 0 on them and 1 between.
Texels lattice() {
  Texels texels{lattice_texels, lattice_texels, {}};
  constexpr uint32_t cell = lattice_texels / 8;
  for (uint32_t y = 0; y < lattice_texels; ++y)
    for (uint32_t x = 0; x < lattice_texels; ++x) {
      const bool bar = x % cell < 3 * cell / 8 || y % cell < 3 * cell / 8;
      texels.rgba.emplace_back(bar ? glm::vec3(0.30f, 0.12f, 0.05f) : glm::vec3(0.55f, 0.6f, 0.6f), bar ? 0.0f : 1.0f);
    }
  return texels;
}

// A square of 1 m in the plane y = 0, facing up.
Mesh plate() {
  Mesh mesh;
  add_grid(mesh, 2, 2, [](uint32_t column, uint32_t row) -> Vertex {
    const glm::vec2 t(column, row);
    return {{t.x - 0.5f, 0, t.y - 0.5f}, {0, 1, 0}, glm::vec4(0), t};
  });
  compute_tangents(mesh);
  return mesh;
}

void fit_views(Scene& scene) {
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
}

}  // namespace

Scene make_three_layer_heart(float time_s) {
  Scene scene = make_heart({.time_s = time_s});
  scene.name = scene.source = "three_layer_heart";
  auto& said = scene.objects.at(0).said.values;
  const Texture muscle = std::get<Texture>(said.at("outer.albedo").value),
                veins = std::get<Texture>(said.at("inner.albedo").value);
  const Texture film = kept_textures("heart_membrane", [&] {
                         return Textures{make_texture("heart membrane", membrane(*muscle), TexelMeaning::colour)};
                       }).front();
  const double depth = std::get<double>(said.at("thickness").value);
  said["outer.albedo"] = said["outer.transparency"] = {film};
  said["inner.albedo"] = said["inner.transparency"] = {muscle};
  said["layer_3.albedo"] = said["layer_3.transparency"] = {veins};
  said["layer_count"] = {3.0};
  said["thickness"] = {0.4 * depth};
  said["layer_3.distance"] = {depth};
  return scene;
}

Scene make_marble_stack() {
  const Textures sheets = kept_textures("marble_sheets", [] {
    Textures made;
    for (uint32_t n = 1; n <= 4; ++n) made.push_back(make_texture(fmt::format("sheet {}", n), sheet(n), TexelMeaning::colour));
    return made;
  });
  Scene scene;
  scene.name = scene.source = "marble_stack";
  scene.objects.push_back(stack_object("block", block_mesh({{{-0.5f, 0, -0.3f}, {0.5f, 0.5f, 0.3f}}}, 0.1f), sheets));
  scene.objects.push_back(stack_object("slab", block_mesh({{{-0.34f, 0, -0.22f}, {0.34f, 0.26f, 0.22f}}}, 0.1f), sheets));
  scene.objects[0].world_from_object = glm::rotate(glm::mat4(1), glm::radians(-25.0f), {0, 1, 0});
  scene.objects[1].world_from_object =
      glm::rotate(glm::translate(glm::mat4(1), {0.03f, 0.5f, 0.02f}), glm::radians(15.0f), {0, 1, 0});
  scene.lights.push_back(directional_light("key", glm::normalize(glm::vec3(-0.6f, 0.8f, 0.7f)), {1.1f, 1.05f, 1.0f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.9f, 0.2f, 0.5f)), {0.2f, 0.24f, 0.3f}));
  scene.ambient = glm::vec3(0.10f);
  scene.background = glm::vec3(0.02f);
  scene.views = {{"front", {0.2f, 0.95f, 2.4f}, {0, 0.36f, 0}, {0, 1, 0}, 32},
                 {"grazing", {-0.80f, 0.86f, 0.80f}, {0.05f, 0.5f, 0}, {0, 1, 0}, 40}};
  fit_views(scene);
  return scene;
}

Scene make_lattice_plate() {
  const Texture bars = make_texture("lattice", lattice(), TexelMeaning::colour);
  Object object;
  object.name = "plate";
  object.mesh = plate();
  object.said.values = {{"albedo", {bars}},    {"outer.albedo", {bars}}, {"outer.transparency", {bars}},
                        {"thickness", {28.0}}, {"scattering", {0.35}},   {"shadowing", {1.0}}};
  Texels stone{lattice_texels, lattice_texels,
               std::vector<glm::vec4>(size_t{lattice_texels} * lattice_texels, {0.72f, 0.68f, 0.60f, 0.5f})};
  const Texture pale = make_texture("pale stone", stone, TexelMeaning::colour);
  object.said.values["inner.albedo"] = object.said.values["inner.transparency"] = {pale};
  Scene scene;
  scene.name = scene.source = "lattice_plate";
  scene.objects.push_back(std::move(object));
  scene.lights.push_back(directional_light("sun", glm::normalize(glm::vec3(-0.8f, 1.0f, 0.25f)), {1.2f, 1.15f, 1.05f}));
  scene.ambient = glm::vec3(0.06f);
  scene.background = glm::vec3(0.02f);
  scene.views = {{"above", {0, 1.5f, 0.5f}, {0, 0, 0}, {0, 1, 0}, 40},
                 {"edge_on", {0.35f, 0.42f, 0.95f}, {0, 0, 0.05f}, {0, 1, 0}, 44}};
  fit_views(scene);
  return scene;
}

}  // namespace lamina
