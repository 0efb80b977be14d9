// SPDX-License-Identifier: Apache-2.0
// Scenes of a few triangles around a point at the origin that faces +y, whose visibility can be worked out by hand.
#pragma once

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "harness/bake/bakes.h"
#include "harness/effects/aperture_lighting/apertures.h"
#include "harness/scene/scene.h"
#include "tests/builtin_library.h"

namespace lamina {

inline constexpr float pi_f = std::numbers::pi_v<float>;

inline Vertex vertex_at(glm::vec3 position, glm::vec3 normal = {0, 1, 0}) {
  return {position, normal, {1, 0, 0, 1}, {position.x * 0.5f + 0.5f, position.z * 0.5f + 0.5f}};
}

inline Object object_of(std::string name, std::vector<Vertex> vertices, std::vector<uint32_t> indices) {
  Object object;
  object.name = std::move(name);
  object.mesh = {std::move(vertices), std::move(indices)};
  return object;
}

// What an object lit through apertures has where nothing is said.
inline EffectValues aperture_values() {
  EffectValues values;
  values.numbers = {{"map_texels", 0}, {"rays", 1024}, {"seed", 1}};
  values.words = {{"baker", "rays"}};
  return values;
}
inline EffectValues& apertures_of(Object& object) {
  return object.effects.try_emplace("aperture_lighting", aperture_values()).first->second;
}

// One tiny triangle around the origin that looks up: what is baked.
inline Object receiver() {
  constexpr float r = 1e-3f;
  Object object = object_of("receiver", {vertex_at({0, 0, 0}), vertex_at({0, 0, r}), vertex_at({r, 0, 0})}, {0, 1, 2});
  apertures_of(object).numbers["bias"] = 1e-4;
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

// As a variant with this [bake] has them baked.
inline const Baked& baked_apertures(Bakes& bakes, size_t object, ApertureKind kind) {
  const BakeOptions options = {
      {"count", kind.choice ? 1 : kind.count}, {"anti", kind.anti}, {"soft", kind.soft}, {"choice", kind.choice}};
  return bakes.baked(builtin_library().effect("aperture_lighting"), object, options);
}
// Of an object without a map, [vertex * count + i].
inline std::vector<Aperture> vertex_apertures(Bakes& bakes, size_t object, ApertureKind kind = {}) {
  const std::vector<std::byte>& bytes = baked_apertures(bakes, object, kind).buffers.at("Apertures");
  std::vector<Aperture> apertures(bytes.size() / sizeof(Aperture));
  if (!apertures.empty()) std::memcpy(apertures.data(), bytes.data(), bytes.size());
  return apertures;
}
// Of an object with a map, texel by texel, as half floats keep them.
inline std::vector<Aperture> map_apertures(Bakes& bakes, size_t object, const std::string& sampler = "aperture_0") {
  const std::vector<std::byte>& level = baked_apertures(bakes, object, {}).textures.at(sampler)->levels.at(0);
  std::vector<uint64_t> halves(level.size() / sizeof(uint64_t));
  std::memcpy(halves.data(), level.data(), level.size());
  std::vector<Aperture> apertures;
  for (const uint64_t half : halves) apertures.push_back(glm::unpackHalf4x16(half));
  return apertures;
}

}  // namespace lamina
