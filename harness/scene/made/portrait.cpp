// SPDX-License-Identifier: Apache-2.0
// See portrait.h.
#include "harness/scene/made/portrait.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/hair_head.h"
#include "harness/scene/made/skin_head.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/translucent_object.h"

namespace lamina {
namespace {

constexpr int petal_count = 6;
constexpr glm::vec3 petal_half_m{0.0105f, 0.0175f, 0.0006f};

// Where the flower sits in the hair, its face along z.
glm::mat4 flower_place() {
  const glm::mat4 place = glm::translate(glm::mat4(1), {0.083f, 0.050f, 0.042f});
  return glm::rotate(glm::rotate(place, glm::radians(38.0f), {0, 1, 0}), glm::radians(-14.0f), {1, 0, 0});
}

// Around the flower's middle, each bent back a little.
Object petal(int index) {
  const TranslucentMedium thin = {{700, 2400, 1500}, {0.97f, 0.62f, 0.74f}, 1.35, 0.0012};
  Object made = translucent_object(fmt::format("petal_{}", index), bent_disc_mesh(petal_half_m, 14, 17), thin);
  const glm::mat4 around = glm::rotate(flower_place(), 2 * float(M_PI) * float(index) / petal_count, {0, 0, 1});
  made.world_from_object = glm::translate(glm::rotate(around, glm::radians(24.0f), {1, 0, 0}),
                                          {0, petal_half_m.y * 1.02f, index % 2 == 0 ? 0.0f : -0.0016f});
  return made;
}

}  // namespace

Scene make_portrait(float time_s) {
  Scene scene = make_skin_head(time_s);
  for (Object& object : make_hair_head().objects)
    if (object.name == "hair" || object.name == "scalp" || object.name == "shoulders")
      scene.objects.push_back(std::move(object));
  for (int i = 0; i < petal_count; ++i) scene.objects.push_back(petal(i));
  Object stamens = coloured_ball("stamens", {0, 0, 0}, 1, {0.75f, 0.52f, 0.10f});
  stamens.world_from_object = glm::scale(flower_place(), glm::vec3(0.0052f, 0.0052f, 0.0040f));
  scene.objects.push_back(std::move(stamens));
  scene.views = {{"face", {-0.10f, 0.03f, 0.66f}, {0.008f, -0.035f, 0}, {0, 1, 0}, 30},
                 {"flower", {0.20f, 0.07f, 0.34f}, {0.070f, 0.035f, 0.03f}, {0, 1, 0}, 22},
                 {"profile", {-0.58f, 0.04f, 0.22f}, {0, -0.03f, 0}, {0, 1, 0}, 30}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
