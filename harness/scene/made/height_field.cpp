// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/height_field.h"

namespace lamina {

Vertex height_vertex(glm::vec3 position, glm::vec2 slope, glm::vec2 uv) {
  const glm::vec3 normal = glm::normalize(glm::vec3(-slope.x, 1, -slope.y));
  const glm::vec3 tangent = glm::normalize(glm::vec3(1, slope.x, 0));
  // cross(y, x) is -z, and v runs along +z.
  return {position, normal, glm::vec4(tangent, -1), uv};
}

void add_grid_triangles(Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows) {
  const auto distance2 = [&](uint32_t a, uint32_t b) {
    const glm::vec3 between = mesh.vertices[a].position - mesh.vertices[b].position;
    return glm::dot(between, between);
  };
  for (uint32_t row = 0; row + 1 < rows; ++row)
    for (uint32_t column = 0; column + 1 < columns; ++column) {
      const uint32_t a = first + row * columns + column, b = a + 1, c = a + columns, d = c + 1;
      if (distance2(a, d) < distance2(b, c))
        mesh.indices.insert(mesh.indices.end(), {a, c, d, a, d, b});
      else
        mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
}

}  // namespace lamina
