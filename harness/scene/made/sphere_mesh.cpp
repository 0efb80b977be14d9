// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/sphere_mesh.h"

#include <array>
#include <cmath>

#include "harness/scene/made/height_field.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {

Mesh sphere_mesh(uint32_t face_points) {
  // What u and v run along; the face looks along cross(v, u), as columns run right and rows run down.
  static constexpr std::array<std::array<glm::vec3, 2>, 6> faces = {{{{{0, 0, -1}, {0, -1, 0}}},
                                                                     {{{0, 0, 1}, {0, -1, 0}}},
                                                                     {{{1, 0, 0}, {0, 0, 1}}},
                                                                     {{{1, 0, 0}, {0, 0, -1}}},
                                                                     {{{1, 0, 0}, {0, -1, 0}}},
                                                                     {{{-1, 0, 0}, {0, -1, 0}}}}};
  constexpr float gap = 0.02f;  // around a chart, as a share of its cell
  Mesh mesh;
  for (uint32_t face = 0; face < 6; ++face) {
    const auto [right, down] = faces[face];
    add_grid(mesh, face_points, face_points, [&, u = right, v = down](uint32_t column, uint32_t row) -> Vertex {
      const glm::vec2 t = glm::vec2(column, row) / static_cast<float>(face_points - 1);
      const glm::vec2 angle = static_cast<float>(M_PI) / 4 * (2.0f * t - 1.0f);
      const glm::vec3 out = glm::normalize(glm::cross(v, u) + std::tan(angle.x) * u + std::tan(angle.y) * v);
      const glm::vec2 uv = (glm::vec2(face % 3, face / 3) + gap + (1 - 2 * gap) * t) / glm::vec2(3, 2);
      return {out, out, glm::vec4(0), uv};
    });
  }
  compute_tangents(mesh);
  return mesh;
}

}  // namespace lamina
