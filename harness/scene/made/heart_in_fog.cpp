// SPDX-License-Identifier: Apache-2.0
// See heart_in_fog.h.
#include "harness/scene/made/heart_in_fog.h"

#include <cmath>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/heart.h"

namespace lamina {
namespace {

constexpr float stone_top_m = -1.35f, bank_half_m = 6, bank_top_m = -0.72f;

// A slab whose upper side has waves. Vertices at one place are moved alike, so it stays closed.
Mesh fog_bank(float time_s) {
  Mesh mesh = block_mesh({{{-bank_half_m, stone_top_m - 0.1f, -bank_half_m}, {bank_half_m, bank_top_m, bank_half_m}}}, 0.3f);
  const float turn = 2 * static_cast<float>(M_PI) * time_s / 9;
  for (Vertex& vertex : mesh.vertices) {
    glm::vec3& p = vertex.position;
    if (p.y != bank_top_m) continue;
    p.y += 0.16f * std::sin(1.3f * p.x + turn) * std::cos(1.1f * p.z - turn) +
           0.07f * std::sin(2.9f * p.x - 2.3f * p.z + 2 * turn);
  }
  return mesh;
}

}  // namespace

Scene make_heart_in_fog(float time_s) {
  Scene scene = make_heart({.time_s = time_s});
  scene.objects.push_back(coloured_object("floor", block_mesh({{{-9, stone_top_m - 0.3f, -9}, {9, stone_top_m, 9}}}, 20),
                                          {0.085f, 0.08f, 0.078f}, false));
  scene.objects.push_back(fog_hull("bank", fog_bank(time_s), glm::mat4(1), 1));
  scene.objects.push_back(fog_ball("veil", {0, 0.1f, 0}, {2.3f, 1.9f, 2.1f}, 0.08f));
  set_fog(scene, 0.75f, {0.20f, 0.235f, 0.28f});
  scene.background = {0.035f, 0.042f, 0.052f};
  scene.lights[0].radiance *= 0.8f;
  scene.lights.push_back(directional_light("behind", glm::normalize(glm::vec3(0.5f, 0.55f, -0.8f)), {0.9f, 1.0f, 1.2f}));
  scene.views = {{"front", {0.2f, 0.75f, 5.4f}, {0.05f, 0.05f, 0}, {0, 1, 0}, 34, 0.05f, 30},
                 {"low", {-2.6f, -0.35f, 3.9f}, {0.1f, 0.0f, 0}, {0, 1, 0}, 36, 0.05f, 30},
                 {"above", {1.5f, 3.4f, 3.4f}, {0.1f, -0.1f, 0}, {0, 1, 0}, 36, 0.05f, 30}};
  return scene;
}

}  // namespace lamina
