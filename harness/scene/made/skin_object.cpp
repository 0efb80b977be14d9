// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/skin_object.h"

#include <cmath>

#include "harness/scene/made/height_field.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {

Object skin_object(std::string name, Mesh mesh, glm::vec3 albedo, const std::map<std::string, double>& numbers) {
  Object object;
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  object.said.calls.insert("skin");
  object.said.values = {{"albedo", {albedo}}, {"skin.albedo", {albedo}}};
  for (const auto& [key, number] : numbers) object.said.values[key] = {number};
  return object;
}

Mesh globe_mesh(uint32_t columns, uint32_t rows, float cut) {
  constexpr float gap = 0.01f;  // around the chart
  Mesh mesh;
  add_grid(mesh, columns, rows, [&](uint32_t column, uint32_t row) -> Vertex {
    const glm::vec2 t = glm::vec2(column, row) / glm::vec2(columns - 1, rows - 1);
    const float longitude =
        2 * static_cast<float>(M_PI) * (column + 1 == columns ? 0 : t.x);  // both ends of a row are one place
    const float polar = cut + (static_cast<float>(M_PI) - 2 * cut) * t.y;
    const glm::vec3 out(-std::sin(longitude) * std::sin(polar), std::cos(polar), -std::cos(longitude) * std::sin(polar));
    return {out, out, glm::vec4(0), gap + (1 - 2 * gap) * t};
  });
  compute_tangents(mesh);
  return mesh;
}

}  // namespace lamina
