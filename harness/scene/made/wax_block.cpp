// SPDX-License-Identifier: Apache-2.0
// See wax_block.h.
#include "harness/scene/made/wax_block.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/translucent_object.h"

namespace lamina {
namespace {

constexpr float ball_m = 0.03f;

// 10 x 8 x 5 cm, standing on y = 0, with a hole of 3 x 3 cm.
Mesh block_with_hole() {
  return block_mesh(
      {{{-0.05f, 0, -0.025f}, {0.05f, 0.08f, 0.025f}, true}, {{-0.025f, 0.03f, -0.025f}, {0.005f, 0.06f, 0.025f}, false}},
      0.005f);
}

}  // namespace

Scene make_wax_block() {
  const TranslucentMedium wax = {{35, 60, 110}, {0.97f, 0.93f, 0.84f}, 1.4, 0.04};
  Scene scene;
  scene.objects.push_back(translucent_object("block", block_with_hole(), wax));
  scene.objects.push_back(translucent_object("ball", sphere_mesh(), wax));
  scene.objects[0].world_from_object = glm::rotate(glm::mat4(1), glm::radians(20.0f), {0, 1, 0});
  scene.objects[1].world_from_object = glm::scale(glm::translate(glm::mat4(1), {-0.105f, ball_m, 0.035f}), glm::vec3(ball_m));
  scene.lights.push_back(directional_light("lamp", glm::normalize(glm::vec3(-0.75f, 0.45f, -0.8f)), {1.7f, 1.6f, 1.45f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(0.6f, 0.4f, 1)), {0.16f, 0.19f, 0.25f}));
  scene.ambient = {0.03f, 0.035f, 0.045f};
  scene.background = {0.02f, 0.022f, 0.027f};
  scene.views = {{"front", {0.03f, 0.12f, 0.36f}, {-0.043f, 0.037f, 0}, {0, 1, 0}, 36},
                 {"lit_side", {-0.26f, 0.17f, -0.26f}, {-0.02f, 0.035f, 0}, {0, 1, 0}, 34},
                 {"through_hole", {-0.06f, 0.075f, 0.17f}, {-0.012f, 0.042f, 0}, {0, 1, 0}, 40}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
