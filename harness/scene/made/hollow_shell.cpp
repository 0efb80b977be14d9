// SPDX-License-Identifier: Apache-2.0
// See hollow_shell.h.
#include "harness/scene/made/hollow_shell.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/translucent_object.h"

namespace lamina {

Scene make_hollow_shell() {
  Scene scene;
  scene.objects.push_back(translucent_object("shell", shell_mesh(0.8f), {{16, 22, 34}, {0.95f, 0.92f, 0.86f}, 1.3, 0.02}));
  scene.objects[0].world_from_object = glm::scale(glm::mat4(1), glm::vec3(0.05f));
  scene.lights.push_back(directional_light("back", glm::normalize(glm::vec3(-0.5f, 0.5f, -1)), {1.3f, 1.2f, 1.05f}));
  scene.lights.push_back(directional_light("side", glm::normalize(glm::vec3(1, 0.15f, 0.2f)), {0.15f, 0.35f, 0.75f}));
  Light lamp;
  lamp.name = "lamp";
  lamp.kind = Light::Kind::point;
  lamp.position = {-0.05f, -0.16f, 0.08f};
  lamp.radiance = {0.016f, 0.009f, 0.004f};
  scene.lights.push_back(lamp);
  for (Light& light : scene.lights) light.casts = true;
  scene.ambient = {0.02f, 0.022f, 0.026f};
  scene.background = {0.02f, 0.022f, 0.027f};
  scene.views = {{"front", {0, 0.03f, 0.22f}, {0, 0, 0}, {0, 1, 0}, 34},
                 {"below", {0.08f, -0.14f, 0.14f}, {0, 0, 0}, {0, 1, 0}, 34}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
