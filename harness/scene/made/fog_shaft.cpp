// SPDX-License-Identifier: Apache-2.0
// See fog_shaft.h.
#include "harness/scene/made/fog_shaft.h"

#include <fmt/format.h>

#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/two_windows.h"

namespace lamina {
namespace {

// From the inner side of the wall to beyond what the room cuts.
constexpr float bar_m = 0.09f, deep_m = 4;

// A rectangle of the window's plane, swept along the sun's rays.
Object swept(const std::string& name, glm::vec2 low, glm::vec2 high, glm::vec3 along, bool hole) {
  Object object = fog_box(name, glm::vec3(low, 0), glm::vec3(high, deep_m), 1, hole);
  object.world_from_object[2] = glm::vec4(along / along.z, 0);
  return object;
}

}  // namespace

Scene make_fog_shaft() {
  Scene scene = make_two_windows();
  const glm::vec3 along = scene.lights.front().direction;
  for (int i = 0; i < 2; ++i) {
    const glm::vec2 low = window_low[i], high = window_high[i], middle = (low + high) / 2.0f;
    scene.objects.push_back(swept(fmt::format("beam_{}", i), low, high, along, false));
    // Bars that cross would be taken away twice where they do, so the rungs end at the bar.
    scene.objects.push_back(
        swept(fmt::format("bar_{}", i), {middle.x - bar_m / 2, low.y}, {middle.x + bar_m / 2, high.y}, along, true));
    for (int side = 0; side < 2; ++side) {
      const float from = side == 0 ? low.x : middle.x + bar_m / 2, to = side == 0 ? middle.x - bar_m / 2 : high.x;
      scene.objects.push_back(
          swept(fmt::format("rung_{}", 2 * i + side), {from, middle.y - bar_m / 2}, {to, middle.y + bar_m / 2}, along, true));
    }
  }
  set_fog(scene, 0.16f, {1.7f, 1.52f, 1.24f});
  return scene;
}

}  // namespace lamina
