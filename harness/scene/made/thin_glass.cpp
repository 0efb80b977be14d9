// SPDX-License-Identifier: Apache-2.0
// See thin_glass.h.
#include "harness/scene/made/thin_glass.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/default_views.h"
#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/glass_stack.h"
#include "harness/scene/made/transparent_object.h"

namespace lamina {
namespace {

constexpr float distance_m = 2, fov_degrees = 30, height_px = 256;

// From the origin, to the right.
Mesh rod(float from, float to, float width) {
  return block_mesh({{{from, -width / 2, -width / 2}, {to, width / 2, width / 2}}}, 10);
}

}  // namespace

Scene make_thin_glass() {
  const float pixel_m = 2 * distance_m * std::tan(glm::radians(fov_degrees / 2)) / height_px;
  Scene scene;
  add_striped_room(scene);
  const auto add = [&](std::string name, Mesh mesh, glm::vec3 foot, float degrees, glm::vec3 color) {
    scene.objects.push_back(transparent_object(std::move(name), std::move(mesh), {color, 0.6, 0.6, 60, 0}));
    scene.objects.back().world_from_object = glm::rotate(glm::translate(glm::mat4(1), foot), glm::radians(degrees), {0, 0, 1});
  };
  constexpr float degrees[] = {0, 5.7f, 11.3f, 18.4f, 26.6f, 35, 45, 55, 63.4f, 71.6f, 78.7f, 84.3f, 90};
  for (int i = 0; i < 13; ++i) {
    const float part = static_cast<float>(i) / 12;
    add(fmt::format("rod_{}", i), rod(0.12f, 0.86f, pixel_m), {-0.42f, 0.1f, 0}, degrees[i],
        glm::mix(glm::vec3(0.75f, 0.12f, 0.08f), glm::vec3(0.08f, 0.22f, 0.75f), part));
  }
  for (int i = 0; i < 4; ++i)
    add(fmt::format("wide_rod_{}", i), rod(0, 0.45f, pixel_m * static_cast<float>(i + 2)),
        {0.06f + 0.12f * static_cast<float>(i), 0.62f - 0.02f * static_cast<float>(i), 0.02f}, 50 - 10 * static_cast<float>(i),
        {0.10f, 0.48f, 0.22f});
  scene.views = {{"front", {0, 0.5f, distance_m}, {0, 0.5f, 0}, {0, 1, 0}, fov_degrees},
                 {"turned", {0.6f, 0.62f, 1.85f}, {0, 0.5f, 0}, {0.1f, 1, 0}, fov_degrees}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
