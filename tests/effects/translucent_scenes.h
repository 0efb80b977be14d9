// SPDX-License-Identifier: Apache-2.0
// Scenes of one translucent object whose light is known in closed form.
#pragma once

#include "harness/effects/translucency/scattered_light.h"
#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/textures.h"

namespace lamina {

struct MediumNumbers {
  glm::vec3 extinction{1};
  double refraction_index = 1, multiple_scattering = 0, wrap = 0.25;
  glm::vec3 albedo{0.5f};
};

inline Object translucent(Mesh mesh, const MediumNumbers& said) {
  Object object;
  object.name = "it";
  object.mesh = std::move(mesh);
  EffectValues& values = object.effects["translucency"];
  values.numbers = {{"extinction_red", double(said.extinction.r)},
                    {"extinction_green", double(said.extinction.g)},
                    {"extinction_blue", double(said.extinction.b)},
                    {"refraction_index", said.refraction_index},
                    {"multiple_scattering", said.multiple_scattering},
                    {"wrap", said.wrap},
                    {"thickness_scale", 1},
                    {"ramp_length", 1},
                    {"thickness_texels", 0}};
  const auto colour = [](glm::vec3 c) { return constant_texture("c", glm::vec4(c, 1), TexelMeaning::colour); };
  values.facts = {{"scattered", double(std::max({said.albedo.r, said.albedo.g, said.albedo.b}))}};
  values.textures = {{"translucent_albedo", colour(said.albedo)},
                     {"translucent_thickness", constant_texture("t", glm::vec4(0.25f), TexelMeaning::data)},
                     {"translucent_ramp", colour(glm::vec3(1))}};
  object.effects["surface"].textures["albedo"] = colour(said.albedo);
  return object;
}

// The albedo as its texture keeps it.
inline glm::dvec3 stored_albedo(const Object& object) {
  return glm::dvec3(glm::vec3(base_texels(*object.effects.at("translucency").textures.at("translucent_albedo")).rgba[0]));
}

// Under one directional light that casts and shines along `direction`, seen from `eye` towards the middle; nothing else lights
// it.
inline Scene lit_alone(Object object, glm::vec3 direction, glm::vec3 eye, float fov_degrees, glm::vec3 target = glm::vec3(0)) {
  Scene scene;
  scene.name = scene.source = "made";
  scene.objects.push_back(std::move(object));
  Light light;
  light.name = "lamp";
  light.direction = glm::normalize(direction);
  light.casts = true;
  scene.lights = {light};
  scene.background = glm::vec3(0);
  View view{"view", eye, target, {0, 1, 0}, fov_degrees};
  if (std::abs(glm::normalize(eye - target).y) > 0.99f) view.up = {0, 0, 1};
  fit_depth(view, bounding_sphere(scene.objects));
  scene.views = {view};
  return scene;
}

}  // namespace lamina
