// SPDX-License-Identifier: Apache-2.0
// Pieces of meshes that scenes made by code share: vertices of surfaces that are a height over the ground, y = h(x, z), and
// the triangles of grids.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// A vertex seen from above, with texture coordinates that run along x and z. `slope` is (dh/dx, dh/dz).
Vertex height_vertex(glm::vec3 position, glm::vec2 slope, glm::vec2 uv);

// Adds the triangles between columns * rows vertices from `first` on, row after row; columns and rows are 2 or more. They face
// the side from which columns run right and rows run down. Each cell is cut along its shorter diagonal, so that ridges and
// valleys stay whole.
void add_grid_triangles(Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows);

// A grid whole: vertex_at(column, row), row by row, and its triangles.
template <class VertexAt>
void add_grid(Mesh& mesh, uint32_t columns, uint32_t rows, const VertexAt& vertex_at) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (uint32_t row = 0; row < rows; ++row)
    for (uint32_t column = 0; column < columns; ++column) mesh.vertices.push_back(vertex_at(column, row));
  add_grid_triangles(mesh, first, columns, rows);
}

}  // namespace lamina
