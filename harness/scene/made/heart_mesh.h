// SPDX-License-Identifier: Apache-2.0
// The mesh of the built-in heart and its unwrap: one chart. The square of texture space, less a margin, covers the closed
// surface once; each side of the square is folded about its middle and sewn to itself, so the seams meet at the back of the
// heart, and the front is one piece. Beyond a side the surface goes on as the square turned by half a turn about that side's
// middle: texels of the margin show what lies across the seam. Sources: Praun and Hoppe, "Spherical Parametrization and
// Remeshing", SIGGRAPH 2003 (the folded square, by an octahedron); the points are then spread over the surface by springs that
// stiffen with length, so that texels are about the same size everywhere.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

// Share of texture space left around the chart on every side: 24 texels at 1024, more than the greatest thickness (16).
inline constexpr float heart_margin = 24.0f / 1024.0f;

// A grid of points over the folded square, at rest (expanded). `cells` is even.
struct HeartGrid {
  int cells = 0;
  std::vector<glm::vec3>
      points;  // (cells + 1)^2, rows top to bottom; points of a side are equal, bit for bit, to those sewn to them
  // Up to one square beyond any side; the same point of the surface inside.
  glm::ivec2 fold(glm::ivec2 at) const;
  // Of the grid points that are sewn into one, the first; all four corners are one.
  glm::ivec2 master(glm::ivec2 at) const;
  size_t index(glm::ivec2 at) const {
    return static_cast<size_t>(at.y) * static_cast<size_t>(cells + 1) + static_cast<size_t>(at.x);
  }
  const glm::vec3& point(glm::ivec2 at) const { return points[index(fold(at))]; }
};
// Made on the first call and kept; safe from several threads.
const HeartGrid& heart_grid();

// The heart at a moment of its beat: `contraction` in [0, 1], 0 expanded and 1 contracted.
Mesh heart_mesh(float contraction);

}  // namespace lamina
