// SPDX-License-Identifier: Apache-2.0
// A scene as data: objects with what effects need of them, lights, views, and one moment in time. World space is right-handed,
// y up, in metres; colours are linear light, Rec. 709 primaries. Angles are degrees where a name says so.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/scene/effect_values.h"
#include "harness/scene/keys.h"

namespace lamina {

struct Library;  // harness/manifest/library.h

// The layout of backend.h's vertex buffers. Texture coordinates: (0,0) is the corner of the image's first texel, v runs down.
struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;   // unit length
  glm::vec4 tangent;  // xyz = unit dP/du, orthogonal to the normal; dP/dv lies along w * cross(normal, tangent), w = +1 or -1
  glm::vec2 uv;
};
static_assert(sizeof(Vertex) == 48 && offsetof(Vertex, normal) == 12 && offsetof(Vertex, tangent) == 24 &&
              offsetof(Vertex, uv) == 40);

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // triangles, counter-clockwise from outside
};

struct ModelLook;

struct Object {
  std::string name;
  Mesh mesh;  // in object space, at the scene's time
  glm::mat4 world_from_object{1};
  // By effect: those that it calls for, and the one for what no other effect draws, whose values every object has.
  std::map<std::string, EffectValues, std::less<>> effects;
  bool solid = true, blocks_light = true;  // as its effects say: see effect_manifest.h
  // Empty, or why this mesh cannot be drawn unwrapped into its own texture ("texture coordinates span 3 tiles ...").
  std::string unwrap_problem;

  // Until load_scene() makes effects of them: what the scene's code says of it, and what its model's material says; null
  // without a model.
  Keys said;
  std::shared_ptr<const ModelLook> look;
};

struct Light {
  enum class Kind { directional, point };
  std::string name;
  Kind kind = Kind::directional;
  glm::vec3 direction{0, -1, 0};  // directional: the way the light travels; unit length
  glm::vec3 position{0};          // point
  glm::vec3 radiance{1};  // colour times intensity: irradiance at normal incidence; a point light's at 1 m, falling as 1/d^2
  // The light is a sphere, and seen as a spherical cap. Effects that know no area lights take its centre.
  float angular_radius = 0;  // directional: radians, from 0 (a point) to pi / 2 (a hemisphere)
  float radius_m = 0;        // point: of the sphere; 0 or more
  bool casts = false;        // passes with the view of a light are drawn for it
};
inline constexpr size_t max_lights = 8;

struct View {
  std::string name;
  glm::vec3 eye{0, 0, 3}, target{0}, up{0, 1, 0};
  float fov_y_degrees = 40;
  float near_m = 0.01f, far_m = 100;
};

struct Scene {
  std::string name;    // "heart", or the file's stem
  std::string source;  // path or built-in name, as the user gave it
  float time_s = 0;
  std::vector<Object> objects;
  std::map<std::string, EffectValues, std::less<>> effects;  // by effect: what it has for the whole scene
  std::vector<Light> lights;
  glm::vec3 ambient{0};        // irradiance from all around
  glm::vec3 background{0.5f};  // linear colour behind everything
  std::vector<View> views;
  bool mesh_moves = false;    // some mesh changes from frame to frame
  bool objects_move = false;  // some object is elsewhere in the next frame
  bool lights_move = false;
  bool moves() const { return mesh_moves || objects_move || lights_move; }
  // Until load_scene() makes values of them: what the scene's code says to effects of the whole scene, by effect.
  std::map<std::string, Keys> said;
  std::vector<std::string> warnings;  // what the loader had to assume, one sentence each
};

// Loads SCENE as commands take it: a built-in scene's name, a .toml scene file, or a .gltf/.glb model. The library's effects
// say what the scene may ask for. `time_s` replaces the scene's own time where given. Throws Error(bad_input).
Scene load_scene(const std::string& scene, const Library& library, std::optional<float> time_s = std::nullopt);

// Names of the built-in scenes.
std::vector<std::string> builtin_scenes();

}  // namespace lamina
