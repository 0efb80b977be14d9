// SPDX-License-Identifier: Apache-2.0
// The surface of what axis-aligned blocks build: rooms, windows cut into walls, boxes. Space is divided along the blocks' faces
// into cells that are solid or not; where one meets the other there is a face. So no surface is hidden in another, there is no
// crack, and what is thick stays thick.
#pragma once

#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct Block {
  glm::vec3 low, high;  // metres; low < high along every axis
  bool solid = true;    // false: a hole
};

// Later blocks replace earlier ones where they overlap; all around is empty. Faces are grids of cells no wider than `spacing_m`
// (> 0), for values per vertex. Normals point out of the solid; vertices are shared within a plane only. The planes lie side by
// side in the unit tile, apart from each other, all at one scale.
Mesh block_mesh(const std::vector<Block>& blocks, float spacing_m);

// Adds `part`, moved by `place` (no scaling), with its unit tile brought into the cell (column, row) of columns * rows cells.
void add_part(Mesh& mesh, const Mesh& part, const glm::mat4& place, glm::uvec2 cell, glm::uvec2 cells);

}  // namespace lamina
