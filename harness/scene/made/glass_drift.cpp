// SPDX-License-Identifier: Apache-2.0
// See glass_drift.h.
#include "harness/scene/made/glass_drift.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/glass_stack.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/transparent_object.h"

namespace lamina {
namespace {

constexpr float distance_m = 2.2f, fov_degrees = 28, height_px = 256;

}  // namespace

Scene make_glass_drift(float time_s) {
  const float pixel_m = 2 * distance_m * std::tan(glm::radians(fov_degrees / 2)) / height_px;
  const glm::vec3 drift(pixel_m * time_s, 0, 0);
  Scene scene;
  add_striped_room(scene);
  const auto add = [&](std::string name, Mesh mesh, const glm::mat4& place, const GlassLook& look) {
    scene.objects.push_back(transparent_object(std::move(name), std::move(mesh), look));
    scene.objects.back().world_from_object = glm::translate(glm::mat4(1), drift) * place;
  };
  const auto at = [](glm::vec3 place) { return glm::translate(glm::mat4(1), place); };
  add("pane", block_mesh({{{-0.2f, 0, -0.01f}, {0.2f, 0.55f, 0}}}, 10), at({-0.28f, 0.14f, 0}), {{0.12f, 0.42f, 0.55f}, 0.3});
  for (int i = 0; i < 8; ++i) {
    const float turn = static_cast<float>(M_PI) * (static_cast<float>(i) + 0.5f) / 8;
    add(fmt::format("spoke_{}", i), block_mesh({{{-0.2f, -pixel_m, -pixel_m}, {0.2f, pixel_m, pixel_m}}}, 10),
        glm::rotate(at({0.24f, 0.68f, 0}), turn, {0, 0, 1}), {{0.72f, 0.30f, 0.06f}, 0.5, 0.5, 60, 0});
  }
  add("ball", sphere_mesh(), glm::scale(at({0.24f, 0.24f, 0}), glm::vec3(0.18f)), {{0.60f, 0.72f, 0.30f}, 0.12, 3});
  scene.views = {{"front", {0, 0.46f, distance_m}, {0, 0.46f, 0}, {0, 1, 0}, fov_degrees},
                 {"turned", {0.9f, 0.6f, 2.0f}, {0, 0.46f, 0}, {0, 1, 0}, fov_degrees}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  scene.mesh_moves = true;
  return scene;
}

}  // namespace lamina
