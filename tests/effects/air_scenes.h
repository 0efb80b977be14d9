// SPDX-License-Identifier: Apache-2.0
// Scenes with an atmosphere whose pictures can be worked out.
#pragma once

#include <string>

#include "harness/scene/declare.h"
#include "tests/builtin_library.h"
#include "tests/graph/quad_scene.h"

namespace lamina {

// The numbers that effect.toml gives without a scene file's, on top of which `numbers` are put.
inline void add_air(Scene& scene, const std::map<std::string, double>& numbers = {}) {
  apply_scene_keys(scene, builtin_library().effect("atmosphere"), {}, builtin_library());
  for (const auto& [name, value] : numbers) scene.effects.at("atmosphere").numbers.at(name) = value;
}

// Degrees from straight up, and about that, from x to z.
inline glm::dvec3 direction_at(double zenith_degrees, double azimuth_degrees) {
  const double zenith = glm::radians(zenith_degrees), azimuth = glm::radians(azimuth_degrees);
  return {std::sin(zenith) * std::cos(azimuth), std::cos(zenith), std::sin(zenith) * std::sin(azimuth)};
}

inline Light sun_at(double zenith_degrees, double azimuth_degrees = 0) {
  Light light;
  light.name = "sun";
  light.direction = glm::vec3(-direction_at(zenith_degrees, azimuth_degrees));
  return light;
}

// The unit square 10 m ahead, which fills the height of the picture, under ambient light of 1; and nothing to its left and
// right in a picture that is wider. Its albedo is `albedo`. Behind it is black.
inline Scene square_in_air(glm::vec3 albedo, const std::map<std::string, double>& numbers, Light sun = sun_at(0)) {
  QuadOptions options;
  options.outer = albedo;
  Scene scene = quad_scene(options);
  scene.objects[0].effects.erase("layered_material");
  scene.lights = {std::move(sun)};
  scene.lights[0].radiance = glm::vec3(0);  // surfaces see the ambient light alone
  add_air(scene, numbers);
  return scene;
}

// Nothing but sky, from `eye_m` above the sea: straight ahead at a zenith angle. The square is behind the eye.
inline Scene sky(double zenith_degrees, Light sun, const std::map<std::string, double>& numbers = {}, float eye_m = 0,
                 float fov_y_degrees = 40) {
  Scene scene = square_in_air({0.5f, 0.5f, 0.5f}, numbers, std::move(sun));
  scene.objects[0].world_from_object[3] = glm::vec4(0, eye_m, 0, 1) - 2e3f * glm::vec4(direction_at(zenith_degrees, 0), 0);
  View& view = scene.views[0];
  view.eye = {0, eye_m, 0};
  view.target = view.eye + 100.0f * glm::vec3(direction_at(zenith_degrees, 0));
  view.up = zenith_degrees < 45 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  view.fov_y_degrees = fov_y_degrees;
  return scene;
}

}  // namespace lamina
