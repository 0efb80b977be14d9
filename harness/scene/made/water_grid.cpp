// SPDX-License-Identifier: Apache-2.0
// See water_grid.h.
#include "harness/scene/made/water_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/scene/made/height_field.h"

namespace lamina {

Mesh water_rectangle(glm::vec2 low, glm::vec2 high, float spacing_m) {
  const glm::vec2 size = high - low;
  const auto columns = static_cast<uint32_t>(std::ceil(size.x / spacing_m)) + 1,
             rows = static_cast<uint32_t>(std::ceil(size.y / spacing_m)) + 1;
  Mesh mesh;
  add_grid(mesh, columns, rows, [&](uint32_t column, uint32_t row) {
    const glm::vec2 uv = glm::vec2(column, row) / glm::vec2(columns - 1, rows - 1), at = low + size * uv;
    return height_vertex({at.x, 0, at.y}, {0, 0}, uv);
  });
  return mesh;
}

Mesh water_disc(float radius_m, float spacing_m, float growth) {
  const auto around = static_cast<uint32_t>(std::ceil(2 * std::numbers::pi_v<float> / growth));
  std::vector<float> rings;
  for (float r = spacing_m; r < radius_m; r += std::max(spacing_m, growth * r)) rings.push_back(r);
  rings.push_back(radius_m);
  Mesh mesh;
  const auto vertex = [&](float r, uint32_t i) {
    const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
    const glm::vec2 at = r * glm::vec2(std::cos(turn), std::sin(turn));
    return height_vertex({at.x, 0, at.y}, {0, 0}, glm::vec2(0.5f) + 0.499f * at / radius_m);
  };
  mesh.vertices.push_back(vertex(0, 0));
  for (const float r : rings)
    for (uint32_t i = 0; i < around; ++i) mesh.vertices.push_back(vertex(r, i));
  const auto place = [&](size_t ring, uint32_t i) { return static_cast<uint32_t>(1 + ring * around + i % around); };
  for (uint32_t i = 0; i < around; ++i) mesh.indices.insert(mesh.indices.end(), {0, place(0, i + 1), place(0, i)});
  for (size_t ring = 0; ring + 1 < rings.size(); ++ring)
    for (uint32_t i = 0; i < around; ++i)
      mesh.indices.insert(mesh.indices.end(), {place(ring, i), place(ring, i + 1), place(ring + 1, i), place(ring, i + 1),
                                               place(ring + 1, i + 1), place(ring + 1, i)});
  return mesh;
}

Object water_object(Scene& scene, Mesh mesh, float spacing_m, float growth) {
  Object object;
  object.name = "water";
  object.mesh = std::move(mesh);
  object.said.calls.insert("water");
  scene.said["water"].values["grid_spacing"] = {double(spacing_m)};
  scene.said["water"].values["grid_growth"] = {double(growth)};
  return object;
}

void set_wave(Scene& scene, int wave, const MadeWave& made) {
  auto& values = scene.said["water"].values;
  values[fmt::format("wave_{}_amplitude", wave)] = {made.amplitude_m};
  values[fmt::format("wave_{}_length", wave)] = {made.length_m};
  values[fmt::format("wave_{}_direction", wave)] = {made.direction_degrees};
  values[fmt::format("wave_{}_steepness", wave)] = {made.steepness};
}

}  // namespace lamina
