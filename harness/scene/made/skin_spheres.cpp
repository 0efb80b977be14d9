// SPDX-License-Identifier: Apache-2.0
// See skin_spheres.h.
#include "harness/scene/made/skin_spheres.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/skin_object.h"

namespace lamina {

Scene make_skin_spheres() {
  Scene scene;
  for (const auto& [name, radius_m, x] : {std::tuple("small", 0.005f, -0.011f), std::tuple("large", 0.010f, 0.006f)}) {
    Object ball = skin_object(name, globe_mesh(129, 65), glm::vec3(1), {{"skin.specular", 0}});
    ball.world_from_object = glm::scale(glm::translate(glm::mat4(1), {x, 0, 0}), glm::vec3(radius_m));
    scene.objects.push_back(std::move(ball));
  }
  // From beside and in front, so that neither ball shades the other.
  scene.lights.push_back(directional_light("lamp", glm::normalize(glm::vec3(0.5f, 0.35f, 0.35f)), {1, 1, 1}));
  scene.ambient = glm::vec3(0);
  scene.background = glm::vec3(0.02f);
  scene.views = {{"front", {0, 0, 0.08f}, {0, 0, 0}, {0, 1, 0}, 26},
                 {"small", {-0.011f, 0, 0.06f}, {-0.011f, 0, 0}, {0, 1, 0}, 11}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
