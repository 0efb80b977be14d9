// SPDX-License-Identifier: Apache-2.0
// A scene whose pictures can be worked out by hand: one unit square in the plane z = 0, facing +z, its texture upright.
#pragma once

#include "harness/scene/scene.h"
#include "harness/scene/textures.h"

namespace lamina {

// The square from (-0.5,-0.5) to (0.5,0.5): u along x, v down y.
inline Mesh unit_square() {
  Mesh mesh;
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
    mesh.vertices.push_back({{uv.x - 0.5f, 0.5f - uv.y, 0}, {0, 0, 1}, {1, 0, 0, -1}, uv});  // dP/dv = -y = -cross(n, t)
  mesh.indices = {0, 2, 1, 0, 3, 2};
  return mesh;
}

inline Texels filled(uint32_t size, const std::function<glm::vec4(uint32_t, uint32_t)>& texel) {
  Texels texels{size, size, {}};
  for (uint32_t y = 0; y < size; ++y)
    for (uint32_t x = 0; x < size; ++x) texels.rgba.push_back(texel(x, y));
  return texels;
}

struct QuadOptions {
  float thickness_texels = 0;
  float transparency = 1;
  glm::vec3 outer{0.5f}, inner{0.25f};
  uint32_t size = 64;
};

// Lit by ambient light of 1 alone, seen head-on so that it fills the frame.
inline Scene quad_scene(const QuadOptions& options) {
  Scene scene;
  scene.name = scene.source = "quad";
  Object object;
  object.name = "quad";
  object.mesh = unit_square();
  object.effects["surface"].textures["albedo"] = constant_texture("albedo", {options.outer, 1}, TexelMeaning::colour);
  EffectValues& layers = object.effects["layered_material"];
  layers.textures["outer_albedo"] = make_texture(
      "outer", filled(options.size, [&](uint32_t, uint32_t) { return glm::vec4(options.outer, options.transparency); }),
      TexelMeaning::colour);
  layers.textures["outer_normal"] = make_texture(
      "normal", filled(options.size, [](uint32_t, uint32_t) { return glm::vec4(0.5f, 0.5f, 1, 1); }), TexelMeaning::normal);
  layers.textures["outer_normal_mean"] =
      make_texture("normal", filled(options.size, [](uint32_t, uint32_t) { return glm::vec4(0.5f, 0.5f, 1, 1); }),
                   TexelMeaning::normal_mean);
  layers.textures["inner_albedo"] = make_texture(
      "inner", filled(options.size, [&](uint32_t, uint32_t) { return glm::vec4(options.inner, 1); }), TexelMeaning::colour);
  layers.numbers = {{"thickness", options.thickness_texels}, {"scattering", 1}};
  layers.facts["transparency"] = options.transparency;
  scene.objects.push_back(object);
  scene.ambient = glm::vec3(1);
  scene.background = glm::vec3(0);
  View view;
  view.name = "head_on";
  view.eye = {0, 0, 10};
  view.fov_y_degrees = glm::degrees(2 * std::atan(0.05f));  // the square fills the height exactly
  scene.views.push_back(view);
  return scene;
}

// Lit from the left by a directional light, with a bumpy normal map and textures that have structure, tilted: not symmetric in
// x or y.
inline Scene bumpy_scene(float thickness_texels, float transparency) {
  QuadOptions options;
  options.thickness_texels = thickness_texels;
  options.transparency = transparency;
  Scene scene = quad_scene(options);
  auto& layers = scene.objects[0].effects.at("layered_material").textures;
  const auto wave = [](uint32_t x, uint32_t y, float f) { return 0.5f + 0.5f * std::sin(f * float(x) + 0.7f * f * float(y)); };
  layers["outer_albedo"] = make_texture("outer",
                                        filled(64,
                                               [&](uint32_t x, uint32_t y) {
                                                 return glm::vec4(0.2f + 0.01f * float(x), 0.9f - 0.01f * float(y),
                                                                  wave(x, y, 0.2f), transparency * wave(y, x, 0.13f));
                                               }),
                                        TexelMeaning::colour);
  const Texels normals = filled(64, [&](uint32_t x, uint32_t y) {
    return glm::vec4(0.5f + 0.3f * (wave(x, y, 0.6f) - 0.5f), 0.5f + 0.3f * (wave(y, x, 0.4f) - 0.5f), 0.9f, 1);
  });
  layers["outer_normal"] = make_texture("normal", normals, TexelMeaning::normal);
  layers["outer_normal_mean"] = make_texture("normal", normals, TexelMeaning::normal_mean);
  layers["inner_albedo"] = make_texture(
      "inner", filled(64, [&](uint32_t x, uint32_t y) { return glm::vec4((x / 8 + y / 8) % 2 ? 0.8f : 0.1f, 0.1f, 0.3f, 1); }),
      TexelMeaning::colour);
  scene.ambient = glm::vec3(0.1f);
  scene.lights.push_back(
      {"key", Light::Kind::directional, glm::normalize(glm::vec3(0.6f, -0.3f, -0.8f)), {}, {1.2f, 1.1f, 1.0f}});
  scene.lights.push_back({"lamp", Light::Kind::point, {}, {0.4f, 0.3f, 0.5f}, {0.1f, 0.15f, 0.2f}});
  scene.views[0].eye = {0.9f, -0.6f, 1.1f};
  scene.views[0].fov_y_degrees = 40;
  return scene;
}

}  // namespace lamina
