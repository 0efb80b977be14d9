// SPDX-License-Identifier: Apache-2.0
// See fog_flight.h.
#include "harness/scene/made/fog_flight.h"

#include <fmt/format.h>

#include <cmath>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/fog_hull.h"

namespace lamina {
namespace {

constexpr float flight_s = 10, flight_m = 48;

Mesh columns() {
  std::vector<Block> blocks;
  for (int row = 0; row < 9; ++row)
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec3 foot(side * 3.2f, 0, -6.0f * static_cast<float>(row));
      blocks.push_back({foot + glm::vec3(-0.55f, 0, -0.55f), foot + glm::vec3(0.55f, 0.4f, 0.55f)});
      blocks.push_back({foot + glm::vec3(-0.4f, 0.4f, -0.4f), foot + glm::vec3(0.4f, 5, 0.4f)});
    }
  return block_mesh(blocks, 10);
}

}  // namespace

Scene make_fog_flight(float time_s) {
  const double flights = time_s / flight_s;
  const float part = static_cast<float>(flights - std::floor(flights)), turn = 2 * static_cast<float>(M_PI) * part;
  Scene scene;
  scene.objects.push_back(
      coloured_object("ground", block_mesh({{{-30, -0.5f, -60}, {30, 0, 12}}}, 100), {0.20f, 0.19f, 0.16f}, false));
  scene.objects.push_back(coloured_object("columns", columns(), {0.52f, 0.46f, 0.38f}, false));
  for (int i = 0; i < 9; ++i) {
    const float along = static_cast<float>(i);
    const glm::vec3 centre(2.2f * std::sin(2.4f * along + turn), 0.5f + 0.5f * std::cos(1.7f * along), -2.5f - 5.2f * along);
    scene.objects.push_back(fog_ball(fmt::format("bank_{}", i), centre,
                                     {4.2f + std::sin(along), 1.5f + 0.5f * std::cos(3 * along), 3.4f},
                                     0.6f + 0.4f * std::sin(2.0f * along), 25 * along));
  }
  set_fog(scene, 0.32f, {0.50f, 0.55f, 0.60f});
  scene.lights.push_back(directional_light("sun", glm::normalize(glm::vec3(0.5f, 0.7f, 0.4f)), {1.1f, 1.0f, 0.85f}));
  scene.ambient = {0.22f, 0.26f, 0.32f};
  scene.background = {0.36f, 0.45f, 0.56f};
  const float z = 6 - flight_m * part;
  scene.views = {{"flight", {0.9f * std::sin(turn), 1.7f, z}, {-0.5f, 1.3f, z - 8}, {0, 1, 0}, 60, 0.1f, 80},
                 {"above", {14, 16, 8}, {0, 0, -18}, {0, 1, 0}, 45, 0.5f, 80}};
  scene.lights_move = true;
  return scene;
}

}  // namespace lamina
