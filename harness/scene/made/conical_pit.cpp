// SPDX-License-Identifier: Apache-2.0
// See conical_pit.h.
#include "harness/scene/made/conical_pit.h"

#include <cmath>
#include <span>
#include <vector>

#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"

namespace lamina {
namespace {

// The rim's polygon lies within 1 - cos(pi / 512) of its circle, 1e-5 of its radius.
constexpr uint32_t segments = 512;

// Rings around the y axis, of radii that grow and heights that rise by `slope`; the unwrap is the view from above.
Mesh rings(std::span<const float> radii, float slope) {
  Mesh mesh;
  const float inner = radii.front(), outer = radii.back();
  for (const float radius : radii)
    for (uint32_t i = 0; i < segments; ++i) {
      const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(i) / segments;
      const glm::vec2 out(std::cos(angle), std::sin(angle)), p = radius * out;
      mesh.vertices.push_back(
          height_vertex({p.x, slope * (radius - inner), p.y}, slope * out, glm::vec2(0.5f) + 0.49f * p / outer));
    }
  for (uint32_t ring = 0; ring + 1 < radii.size(); ++ring)
    for (uint32_t i = 0; i < segments; ++i) {
      const uint32_t a = ring * segments + i, b = ring * segments + (i + 1) % segments, c = a + segments, d = b + segments;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
    }
  return mesh;
}

// The innermost ring closed by a fan around the middle.
Mesh disc(std::span<const float> radii) {
  Mesh mesh = rings(radii, 0);
  const auto middle = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(height_vertex({0, 0, 0}, {0, 0}, {0.5f, 0.5f}));
  for (uint32_t i = 0; i < segments; ++i) mesh.indices.insert(mesh.indices.end(), {middle, (i + 1) % segments, i});
  return mesh;
}

}  // namespace

Scene make_conical_pit() {
  const std::vector<float> floor = {0.0125f, 0.025f, 0.0375f, pit_floor_radius_m}, cone = {pit_floor_radius_m, pit_radius_m};
  const float depth = pit_radius_m / std::tan(glm::radians(pit_rim_degrees));
  Scene scene;
  scene.objects.push_back(coloured_object("floor", disc(floor), {0.5f, 0.5f, 0.5f}, true));
  scene.objects.push_back(
      coloured_object("cone", rings(cone, depth / (pit_radius_m - pit_floor_radius_m)), {0.3f, 0.3f, 0.3f}, false));
  // From 35 to 55 degrees off the zenith: a good quarter of it is behind the rim.
  const float from_zenith = glm::radians(45.0f);
  scene.lights.push_back(
      directional_light("sun", {std::sin(from_zenith), std::cos(from_zenith), 0}, glm::vec3(1), glm::radians(10.0f)));
  scene.ambient = {0.2f, 0.2f, 0.2f};
  scene.background = {0.1f, 0.1f, 0.1f};
  scene.views = {{"floor", {0, 0.16f, 0}, {0, 0, 0}, {0, 0, -1}, 34, 0.02f, 4},
                 {"pit", {0, 2.2f, 1.6f}, {0, 0.35f, 0}, {0, 1, 0}, 50, 0.1f, 8}};
  return scene;
}

}  // namespace lamina
