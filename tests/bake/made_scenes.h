// SPDX-License-Identifier: Apache-2.0
// Scenes of a few triangles around a point at the origin that faces +y, whose visibility can be worked out by hand.
#pragma once

#include <cmath>
#include <numbers>

#include "harness/scene/scene.h"

namespace lamina {

inline Vertex vertex_at(glm::vec3 position, glm::vec3 normal = {0, 1, 0}) {
  return {position, normal, {1, 0, 0, 1}, {position.x * 0.5f + 0.5f, position.z * 0.5f + 0.5f}};
}

inline Object object_of(std::string name, std::vector<Vertex> vertices, std::vector<uint32_t> indices) {
  Object object;
  object.name = std::move(name);
  object.mesh = {std::move(vertices), std::move(indices)};
  return object;
}

// One tiny triangle around the origin that looks up: what is baked.
inline Object receiver() {
  constexpr float r = 1e-3f;
  Object object = object_of("receiver", {vertex_at({0, 0, 0}), vertex_at({0, 0, r}), vertex_at({r, 0, 0})}, {0, 1, 2});
  object.apertures.emplace();
  object.apertures->bias_m = 1e-4f;
  return object;
}

// A ring of quads between two circles around the y axis, given by radius and height: a disc (from radius 0), a cone, a wall.
inline Object ring(std::string name, float r0, float y0, float r1, float y1, uint32_t sides = 256) {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    vertices.push_back(vertex_at({r0 * c, y0, r0 * s}));
    vertices.push_back(vertex_at({r1 * c, y1, r1 * s}));
    const uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    for (const uint32_t index : {a, b, a + 1, b, b + 1, a + 1}) indices.push_back(index);
  }
  return object_of(std::move(name), std::move(vertices), std::move(indices));
}

// A quad from four corners.
inline Object quad(std::string name, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
  return object_of(std::move(name), {vertex_at(a), vertex_at(b), vertex_at(c), vertex_at(d)}, {0, 1, 2, 0, 2, 3});
}

inline Scene scene_of(std::vector<Object> objects) {
  Scene scene;
  scene.name = scene.source = "made";
  scene.objects = std::move(objects);
  return scene;
}

}  // namespace lamina
