// SPDX-License-Identifier: Apache-2.0
// See fog_valley.h.
#include "harness/scene/made/fog_valley.h"

#include <cmath>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/fog_hull.h"
#include "harness/scene/made/terrain.h"

namespace lamina {
namespace {

constexpr float lake_half_m = 2520, lake_floor_m = -40, lake_surface_m = 250, lake_spacing_m = 120;

// A slab whose upper side has waves. Vertices at one place are moved alike, so it stays closed.
Mesh lake(float time_s) {
  Mesh mesh =
      block_mesh({{{-lake_half_m, lake_floor_m, -lake_half_m}, {lake_half_m, lake_surface_m, lake_half_m}}}, lake_spacing_m);
  const float turn = 2 * static_cast<float>(M_PI) * time_s / 24;
  for (Vertex& vertex : mesh.vertices) {
    glm::vec3& p = vertex.position;
    if (p.y != lake_surface_m) continue;
    p.y += 34 * std::sin(p.x / 260 + turn) * std::cos(p.z / 330 - turn) + 18 * std::sin((p.x + 1.7f * p.z) / 150 + 2 * turn);
  }
  return mesh;
}

}  // namespace

Scene make_fog_valley(float time_s) {
  Scene scene = make_terrain(time_s);
  scene.objects.push_back(fog_hull("fog", lake(time_s), glm::mat4(1), 1));
  set_fog(scene, 0.0022f, scene.ambient * 1.4f + 0.06f);
  scene.mesh_moves = true;
  return scene;
}

}  // namespace lamina
