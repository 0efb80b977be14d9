// SPDX-License-Identifier: Apache-2.0
// Cards of hair whose pictures can be worked out by hand: squares that face the eye, each a card, under ambient light alone.
#pragma once

#include "harness/scene/declare.h"
#include "harness/scene/facts.h"
#include "harness/scene/made/strand_texture.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/quad_scene.h"

namespace lamina {

struct CardSquare {
  float z = 0, left = -0.5f, right = 0.5f;  // metres; 1.2 m high
  glm::vec2 uv_low{0}, uv_high{1};
};

inline Mesh card_squares(const std::vector<CardSquare>& squares) {
  Mesh mesh;
  for (const CardSquare& square : squares) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
      mesh.vertices.push_back({{glm::mix(square.left, square.right, at.x), 0.6f - 1.2f * at.y, square.z},
                               {0, 0, 1},
                               {1, 0, 0, -1},
                               glm::mix(square.uv_low, square.uv_high, at)});
    for (const uint32_t corner : {0u, 2u, 1u, 0u, 3u, 2u}) mesh.indices.push_back(first + corner);
  }
  return mesh;
}

inline Object hair_of(Mesh mesh, const Texels& albedo) {
  Object object;
  object.name = "hair";
  object.mesh = std::move(mesh);
  object.said.calls.insert("hair");
  object.said.values = {{"hair.albedo", {make_texture("strands", albedo, TexelMeaning::colour)}}, {"hair.strength", {0.0}}};
  return object;
}

// Two opacities side by side, each of two texels: from u = 0.65 to 0.85 there is the right one alone.
inline Texels two_opacities(float left, float right, glm::vec3 colour = glm::vec3(1)) {
  const glm::vec4 a(colour, left), b(colour, right);
  return {4, 1, {a, a, b, b}};
}

// What the loader does for a scene that a test makes.
inline Scene declared_scene(std::vector<Object> objects) {
  Scene scene;
  scene.name = scene.source = "cards";
  scene.objects = std::move(objects);
  scene.ambient = glm::vec3(1);
  scene.background = glm::vec3(0);
  View view;
  view.name = "head_on";
  view.eye = {0, 0, 10};
  view.near_m = 5, view.far_m = 20;
  view.fov_y_degrees = glm::degrees(2 * std::atan(0.05f));  // 1 m at z = 0 fills the height exactly
  scene.views.push_back(view);
  declare_objects(scene.objects, builtin_library());
  declare_said(scene, builtin_library());
  declare_scene(scene, builtin_library());
  for (Object& object : scene.objects)
    if (object.effects.contains("hair")) settle_facts(object, builtin_library().effect("hair"));
  return scene;
}

// Cards of one opacity each, one behind the other; two at most.
inline Scene uniform_cards(float front, std::optional<float> back = std::nullopt) {
  std::vector<CardSquare> squares = {{0, -0.6f, 0.6f, {0.25f, 0.1f}, {0.4f, 0.9f}}};
  if (back) squares.push_back({-0.5f, -0.7f, 0.7f, {0.65f, 0.1f}, {0.8f, 0.9f}});
  // The first column is empty, so that the texture has a hole whatever the opacities.
  Texels tall{8, 2, {}};
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 8; ++column)
      tall.rgba.push_back(glm::vec4(1, 1, 1, column == 0 ? 0 : column < 4 ? front : back.value_or(front)));
  return declared_scene({hair_of(card_squares(squares), tall)});
}

inline double mean_red(const Image& image) {
  double sum = 0;
  for (size_t i = 0; i < image.rgba.size(); i += 4) sum += double(image.rgba[i]);
  return sum / (double(image.rgba.size()) / 4);
}

}  // namespace lamina
