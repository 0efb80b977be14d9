// SPDX-License-Identifier: Apache-2.0
// See two_windows.h.
#include "harness/scene/made/two_windows.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"

namespace lamina {
namespace {

constexpr float wall_m = 0.24f, spacing_m = 0.08f;

Mesh room() {
  std::vector<Block> blocks = {{room_low - wall_m, room_high + wall_m, true}, {room_low, room_high, false}};
  for (int i = 0; i < 2; ++i) blocks.push_back({glm::vec3(window_low[i], -wall_m), glm::vec3(window_high[i], 0), false});
  return block_mesh(blocks, spacing_m);
}

// Two crates, one of them on the other, a bench and a column.
Mesh boxes() {
  struct Box {
    glm::vec3 size, place;  // the middle of its bottom
    float turn_degrees;
  };
  static constexpr Box all[4] = {{{0.80f, 0.70f, 0.80f}, {-1.35f, 0, 1.75f}, 24},
                                 {{0.45f, 0.45f, 0.45f}, {-1.40f, 0.70f, 1.78f}, -12},
                                 {{1.50f, 0.42f, 0.45f}, {1.10f, 0, 2.30f}, -18},
                                 {{0.40f, 1.70f, 0.40f}, {1.95f, 0, 0.85f}, 8}};
  Mesh mesh;
  for (uint32_t i = 0; i < 4; ++i) {
    const glm::vec3 half = all[i].size / 2.0f;
    const Mesh box = block_mesh({{{-half.x, 0, -half.z}, {half.x, all[i].size.y, half.z}, true}}, spacing_m);
    const glm::mat4 moved = glm::translate(glm::mat4(1), all[i].place);
    add_part(mesh, box, glm::rotate(moved, glm::radians(all[i].turn_degrees), {0, 1, 0}), {i % 2, i / 2}, {2, 2});
  }
  return mesh;
}

}  // namespace

Scene make_two_windows() {
  Scene scene;
  scene.objects.push_back(coloured_object("room", room(), {0.66f, 0.62f, 0.56f}, true));
  scene.objects.push_back(coloured_object("boxes", boxes(), {0.42f, 0.26f, 0.15f}, true));
  const glm::vec3 to_sun = glm::normalize(glm::vec3(-0.42f, 0.80f, -1.0f));
  scene.lights.push_back(directional_light("sun", to_sun, {1.35f, 1.20f, 0.98f}, glm::radians(1.0f)));
  scene.ambient = {1.20f, 1.38f, 1.60f};  // a bright sky: the room sees little of it
  scene.background = {0.62f, 0.74f, 0.90f};
  scene.views = {{"windows", {0.9f, 1.55f, 3.8f}, {-0.15f, 1.05f, 0}, {0, 1, 0}, 68, 0.05f, 12},
                 {"corner", {-2.25f, 1.9f, 0.25f}, {1.1f, 0.4f, 3.2f}, {0, 1, 0}, 66, 0.05f, 12},
                 {"floor", {-0.3f, 2.55f, 3.85f}, {-0.1f, 0, 1.5f}, {0, 1, 0}, 62, 0.05f, 12}};
  return scene;
}

}  // namespace lamina
