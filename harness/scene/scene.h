// SPDX-License-Identifier: Apache-2.0
// A scene as data: objects with their layers, lights, views, and one moment in time. World space is right-handed, y up, in
// metres; colours are linear light, Rec. 709 primaries. Angles are degrees where a name says so.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/core/image.h"

namespace lamina {

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

// Oat, "Rendering Gooney Materials with Multiple Layers", SIGGRAPH 2006 course, chapter 4.
struct LayeredMaterial {
  std::shared_ptr<const TextureImage> outer_albedo;  // rgba8_srgb; alpha = transparency: 1 shows the inner layer, 0 hides it
  std::shared_ptr<const TextureImage> outer_normal;  // rgba8_unorm, tangent space, x along +u, y along +v (down), n = 2 t - 1
  std::shared_ptr<const TextureImage> inner_albedo;  // rgba8_srgb, alpha unused
  float thickness_texels = 8;  // distance from outer to inner layer, in texels of inner_albedo's base level; >= 0
  float scattering = 1;        // radius of the light's blur per texel of thickness; >= 0
  float max_transparency = 1;  // the greatest transparency of any texel of outer_albedo that the mesh shows
};

// How the visibility of an object's points is baked into apertures (Oat and Sander, "Ambient Aperture Lighting"). The object
// must not move or change its shape.
struct ApertureBake {
  enum class Baker : uint8_t { rays, spherical_harmonics } baker = Baker::rays;
  uint32_t map_texels = 0;  // side of the map over the object's unwrap; 0: a point is a vertex
  uint32_t rays = 1024;     // a point
  uint64_t seed = 1;
  std::optional<float> bias_m;  // how far rays start above the surface; else a fraction of the scene's size
};

struct Object {
  std::string name;
  Mesh mesh;  // in object space, at the scene's time
  glm::mat4 world_from_object{1};
  std::optional<LayeredMaterial> layers;
  std::optional<ApertureBake> apertures;       // lit through baked apertures; not beside layers
  std::shared_ptr<const TextureImage> albedo;  // rgba8_srgb; what an object without layers shows; never null
  // Empty, or why this mesh cannot be drawn unwrapped into its own texture ("texture coordinates span 3 tiles ...").
  std::string unwrap_problem;
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
  std::vector<Light> lights;
  glm::vec3 ambient{0};        // irradiance from all around
  glm::vec3 background{0.5f};  // linear colour behind everything
  std::vector<View> views;
  bool mesh_moves = false;  // some mesh changes from frame to frame
  bool lights_move = false;
  std::vector<std::string> warnings;  // what the loader had to assume, one sentence each
};

// Loads SCENE as commands take it: a built-in scene's name, a .toml scene file, or a .gltf/.glb model.
// `time_s` replaces the scene's own time where given. Throws Error(bad_input).
Scene load_scene(const std::string& scene, std::optional<float> time_s = std::nullopt);

// Names of the built-in scenes.
std::vector<std::string> builtin_scenes();

}  // namespace lamina
