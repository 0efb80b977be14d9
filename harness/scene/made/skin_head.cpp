// SPDX-License-Identifier: Apache-2.0
// See skin_head.h.
#include "harness/scene/made/skin_head.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/head_textures.h"
#include "harness/scene/made/skin_object.h"

namespace lamina {
namespace {

Object head_object(std::string name, glm::vec3 tone, uint32_t detail, uint32_t texels) {
  const HeadTextures textures = head_textures(tone, texels);
  Object head = skin_object(std::move(name), head_mesh(detail), tone, {{"skin.specular", 0.34}, {"skin.roughness", 0.32}});
  head.said.values["skin.albedo"] = {textures.albedo};
  head.said.values["skin.normal"] = {textures.normal};
  head.said.values["skin.specular_map"] = {textures.specular};
  head.said.values["skin.translucency"] = {textures.translucency};
  return head;
}

void light_heads(Scene& scene, float time_s) {
  const float azimuth = glm::radians(-48 + 25 * std::sin(time_s));
  scene.lights.push_back(
      directional_light("key", glm::normalize(glm::vec3(std::sin(azimuth), 0.55f, std::cos(azimuth))), {1.60f, 1.50f, 1.40f}));
  scene.lights.push_back(directional_light("rim", glm::normalize(glm::vec3(0.75f, 0.35f, -0.75f)), {0.8f, 0.84f, 0.92f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.7f, 0.0f, 0.7f)), {0.16f, 0.18f, 0.22f}));
  for (Light& light : scene.lights) light.casts = light.name != "fill";
  scene.lights_move = true;
  scene.ambient = {0.075f, 0.080f, 0.090f};
  scene.background = {0.030f, 0.034f, 0.040f};
}

void fit_views(Scene& scene) {
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
}

}  // namespace

Scene make_skin_head(float time_s) {
  Scene scene;
  scene.objects.push_back(head_object("head", {0.62f, 0.385f, 0.29f}, 320, 1024));
  light_heads(scene, time_s);
  scene.views = {{"face", {-0.16f, 0.0f, 0.60f}, {0, -0.022f, 0}, {0, 1, 0}, 27},
                 {"far", {-0.16f, 0.0f, 2.60f}, {0, -0.022f, 0}, {0, 1, 0}, 40},
                 {"nose", {-0.06f, -0.01f, 0.27f}, {0, -0.025f, 0.08f}, {0, 1, 0}, 24},
                 {"ear", {0.20f, 0.02f, 0.30f}, {0.070f, -0.004f, -0.01f}, {0, 1, 0}, 20}};
  fit_views(scene);
  return scene;
}

Scene make_skin_tones(float time_s) {
  Scene scene;
  scene.objects.push_back(head_object("pale", {0.68f, 0.46f, 0.37f}, 192, 512));
  scene.objects.push_back(head_object("tan", {0.40f, 0.225f, 0.145f}, 192, 512));
  scene.objects.push_back(head_object("dark", {0.155f, 0.080f, 0.050f}, 192, 512));
  for (size_t i = 0; i < 3; ++i)
    scene.objects[i].world_from_object = glm::translate(glm::mat4(1), {0.21f * (static_cast<float>(i) - 1), 0, 0});
  light_heads(scene, time_s);
  scene.views = {{"three", {-0.1f, 0.0f, 1.30f}, {0, -0.03f, 0}, {0, 1, 0}, 27},
                 {"dark", {0.12f, -0.01f, 0.55f}, {0.21f, -0.025f, 0}, {0, 1, 0}, 27}};
  fit_views(scene);
  return scene;
}

}  // namespace lamina
