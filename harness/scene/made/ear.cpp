// SPDX-License-Identifier: Apache-2.0
// See ear.h.
#include "harness/scene/made/ear.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/translucent_object.h"

namespace lamina {

Scene make_ear() {
  const TranslucentMedium skin = {{770, 1050, 1490}, {0.96f, 0.84f, 0.68f}, 1.4, 0.002};
  const TranslucentMedium head = {skin.extinction, skin.albedo, 1.4, 0.05};
  Scene scene;
  scene.objects.push_back(translucent_object("ear", bent_disc_mesh({0.019f, 0.032f, 0.0014f}, 7), skin));
  scene.objects.push_back(translucent_object("head", bent_disc_mesh({0.075f, 0.10f, 0.085f}, 0), head));
  // At the head's side, its rim turned a little forward.
  scene.objects[0].world_from_object =
      glm::rotate(glm::translate(glm::mat4(1), {0.093f, 0.0f, 0.0f}), glm::radians(18.0f), {0, 1, 0});
  scene.lights.push_back(directional_light("sun", glm::normalize(glm::vec3(0.35f, 0.3f, -1)), {3.4f, 3.1f, 2.7f}));
  scene.lights.push_back(directional_light("fill", glm::normalize(glm::vec3(-0.3f, 0.4f, 1)), {0.22f, 0.24f, 0.28f}));
  scene.ambient = {0.05f, 0.055f, 0.065f};
  scene.background = {0.03f, 0.034f, 0.04f};
  scene.views = {{"ear", {0.12f, 0.01f, 0.22f}, {0.085f, 0, 0}, {0, 1, 0}, 30},
                 {"head", {0.08f, 0.05f, 0.50f}, {0.02f, 0, 0}, {0, 1, 0}, 32}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
