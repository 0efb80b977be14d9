// SPDX-License-Identifier: Apache-2.0
// See leaf_pair.h.
#include "harness/scene/made/leaf_pair.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/translucent_object.h"

namespace lamina {

Scene make_leaf_pair() {
  const TranslucentMedium leaf = {{2600, 1300, 4200}, {0.60f, 0.86f, 0.30f}, 1.4, 0.0008};
  Scene scene;
  scene.objects.push_back(translucent_object("near_leaf", bent_disc_mesh({0.022f, 0.045f, 0.0004f}, 5), leaf));
  scene.objects.push_back(translucent_object("far_leaf", bent_disc_mesh({0.020f, 0.042f, 0.0004f}, 6), leaf));
  scene.objects[0].world_from_object = glm::rotate(glm::mat4(1), glm::radians(20.0f), {0, 0, 1});
  scene.objects[1].world_from_object =
      glm::rotate(glm::translate(glm::mat4(1), {0.018f, 0.006f, -0.02f}), glm::radians(-35.0f), {0.2f, 0.3f, 1});
  scene.lights.push_back(directional_light("sun", glm::normalize(glm::vec3(-0.25f, 0.5f, -1)), {3.0f, 2.9f, 2.6f}));
  scene.ambient = {0.10f, 0.12f, 0.15f};
  scene.background = {0.06f, 0.08f, 0.10f};
  scene.views = {{"under", {0.02f, -0.02f, 0.17f}, {0.006f, 0.002f, 0}, {0, 1, 0}, 40},
                 {"sunny_side", {-0.05f, 0.10f, -0.15f}, {0.006f, 0.002f, -0.008f}, {0, 1, 0}, 38}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
