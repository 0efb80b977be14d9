// SPDX-License-Identifier: Apache-2.0
// See heart_mesh.h.
#include "harness/scene/heart_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/scene/heart_shape.h"

namespace lamina {
namespace {

// The middle of the chart looks to the front, a little to the left and up; up runs along the square's diagonal, so that the four
// folds' middles, where the unwrap is pinched, lie off the silhouette's top and bottom.
glm::vec3 chart_direction(float x, float y) {
  const glm::vec3 front = glm::normalize(glm::vec3(0.10f, 0.12f, 1.0f));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), front)), up = glm::cross(front, right);
  const glm::vec3 ex = glm::normalize(right + up), ey = glm::normalize(up - right);
  // Octahedron unfolded onto [-1, 1]^2: the middle diamond is its front half, the corners its back half turned over.
  const float z = 1 - std::abs(x) - std::abs(y);
  const float folded_x = z >= 0 ? x : std::copysign(1 - std::abs(y), x);
  const float folded_y = z >= 0 ? y : std::copysign(1 - std::abs(x), y);
  return glm::normalize(folded_x * ex + folded_y * ey + z * front);
}

// Where a ray from inside the ungrown body leaves it for good.
glm::vec3 cast_out(glm::vec3 direction) {
  const glm::vec3 inside(-0.05f, 0.0f, -0.02f);
  float r = 2.0f;
  // Distances are estimates, so steps are held back.
  for (int i = 0; i < 200 && r > 0.05f; ++i) {
    const float d = heart_distance(inside + r * direction, 0);
    if (d < 1e-3f) break;
    r -= 0.5f * std::min(d, 0.1f);
  }
  return inside + r * direction;
}

void sew(HeartGrid& grid) {
  for (int y = 0; y <= grid.cells; ++y)
    for (int x = 0; x <= grid.cells; ++x) grid.points[grid.index({x, y})] = grid.points[grid.index(grid.master({x, y}))];
}

// One round of springs: every point moves along the surface towards its eight neighbours, the farther ones pulling harder.
void spread(HeartGrid& grid, float growth, int newton_steps) {
  static constexpr std::array<std::pair<int, int>, 8> around = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
  std::vector<glm::vec3> moved(grid.points.size());
  for (int y = 0; y <= grid.cells; ++y)
    for (int x = 0; x <= grid.cells; ++x) {
      const glm::vec3 p = grid.point({x, y});
      glm::vec3 pull(0);
      float total = 0;
      for (const auto& [dx, dy] : around) {
        const glm::vec3 to = grid.point({x + dx, y + dy}) - p;
        // Stiffness grows with length squared; corners count half, being sqrt(2) as far in the square.
        const float weight = (dx != 0 && dy != 0 ? 0.25f : 1.0f) * (glm::dot(to, to) + 1e-8f);
        pull += weight * to;
        total += weight;
      }
      pull *= 0.6f / total;
      const glm::vec3 g = heart_gradient(p, growth);
      pull -= g * (glm::dot(pull, g) / std::max(glm::dot(g, g), 1e-6f));
      moved[grid.index({x, y})] = onto_heart(p + pull, growth, newton_steps);
    }
  grid.points = std::move(moved);
  sew(grid);
}

HeartGrid refined(const HeartGrid& coarse) {
  HeartGrid fine;
  fine.cells = 2 * coarse.cells;
  fine.points.resize(static_cast<size_t>(fine.cells + 1) * static_cast<size_t>(fine.cells + 1));
  for (int y = 0; y <= fine.cells; ++y)
    for (int x = 0; x <= fine.cells; ++x) {
      const glm::ivec2 low(x / 2, y / 2), high((x + 1) / 2, (y + 1) / 2);
      fine.points[fine.index({x, y})] = 0.25f * (coarse.point(low) + coarse.point({high.x, low.y}) +
                                                 coarse.point({low.x, high.y}) + coarse.point(high));
    }
  sew(fine);
  return fine;
}

HeartGrid make_grid() {
  HeartGrid grid;
  grid.cells = 40;
  const int n = grid.cells;
  grid.points.resize(static_cast<size_t>(n + 1) * static_cast<size_t>(n + 1));
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      grid.points[grid.index({x, y})] =
          cast_out(chart_direction(2.0f * static_cast<float>(x) / static_cast<float>(n) - 1, 1 - 2.0f * static_cast<float>(y) / static_cast<float>(n)));
  sew(grid);
  // Rounds chosen by looking at the largest stretch: more change it by less than a tenth.
  for (int i = 0; i < 40; ++i) spread(grid, 0, 1);
  constexpr int growth_steps = 60;
  for (int step = 1; step <= growth_steps; ++step)
    for (int i = 0; i < 4; ++i) spread(grid, static_cast<float>(step) / growth_steps, 1);
  for (int i = 0; i < 60; ++i) spread(grid, 1, 1);
  grid = refined(grid);
  for (int i = 0; i < 24; ++i) spread(grid, 1, 1);
  grid = refined(grid);
  for (int i = 0; i < 8; ++i) spread(grid, 1, i < 7 ? 1 : 3);
  return grid;
}

// The ventricles draw in towards their axis, shorten towards the base and twist; the vessels stay.
glm::vec3 beat(glm::vec3 p, float contraction) {
  const glm::vec3 span = heart_apex - heart_base, axis = glm::normalize(span);
  const float h = glm::dot(p - heart_base, axis) / glm::length(span);  // 0 base, 1 apex
  const float t = std::clamp((h + 0.15f) / 0.55f, 0.0f, 1.0f), share = contraction * t * t * (3 - 2 * t);
  glm::vec3 along = heart_base + axis * (h * glm::length(span));
  const glm::vec3 across = p - along;
  // Ejection shortens a left ventricle by about a tenth, narrows it by a fifth and turns its apex by about twelve degrees.
  along -= axis * (0.10f * share * h * glm::length(span));
  const float angle = glm::radians(12.0f) * share * h;
  const glm::vec3 turned = std::cos(angle) * across + std::sin(angle) * glm::cross(axis, across);
  return along + turned * (1 - 0.17f * share);
}

}  // namespace

glm::ivec2 HeartGrid::fold(glm::ivec2 at) const {
  if (at.y < 0) at = {cells - at.x, -at.y};
  if (at.y > cells) at = {cells - at.x, 2 * cells - at.y};
  if (at.x < 0) at = {-at.x, cells - at.y};
  if (at.x > cells) at = {2 * cells - at.x, cells - at.y};
  return at;
}

glm::ivec2 HeartGrid::master(glm::ivec2 at) const {
  const bool on_row = at.y == 0 || at.y == cells, on_column = at.x == 0 || at.x == cells;
  if (on_row && on_column) return {0, 0};
  if (on_row) return {std::min(at.x, cells - at.x), at.y};
  if (on_column) return {at.x, std::min(at.y, cells - at.y)};
  return at;
}

const HeartGrid& heart_grid() {
  static const HeartGrid made = make_grid();
  return made;
}

Mesh heart_mesh(float contraction) {
  const HeartGrid& rest = heart_grid();
  HeartGrid moved = rest;
  for (glm::vec3& p : moved.points) p = beat(p, contraction);

  const int n = rest.cells;
  Mesh mesh;
  mesh.indices.reserve(static_cast<size_t>(n) * static_cast<size_t>(n) * 6);
  std::vector<glm::vec3> normals(moved.points.size(), glm::vec3(0));  // at masters, so that both sides of a seam share one
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const std::array<glm::ivec2, 4> corner = {{{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}};
      for (const std::array<int, 3> triangle : {std::array{0, 2, 3}, std::array{0, 3, 1}}) {
        std::array<glm::vec3, 3> p;
        for (size_t i = 0; i < 3; ++i) p[i] = moved.points[moved.index(corner[triangle[i]])];
        const glm::vec3 twice_area = glm::cross(p[1] - p[0], p[2] - p[0]);
        for (const int c : triangle) {
          mesh.indices.push_back(static_cast<uint32_t>(moved.index(corner[c])));
          normals[moved.index(moved.master(corner[c]))] += twice_area;
        }
      }
    }

  mesh.vertices.resize(moved.points.size());
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const glm::ivec2 at(x, y);
      Vertex& v = mesh.vertices[moved.index(at)];
      v.position = moved.points[moved.index(at)];
      v.uv = heart_margin + (1 - 2 * heart_margin) * glm::vec2(at) / static_cast<float>(n);
      v.normal = glm::normalize(normals[moved.index(moved.master(at))]);
      // Differences reach across seams, so that both sides agree. In a fold's middle they vanish: there the row inside stands in.
      glm::vec3 along_u = moved.point({x + 1, y}) - moved.point({x - 1, y});
      if (glm::dot(along_u, along_u) < 1e-10f) {
        const glm::ivec2 inside = glm::clamp(at, glm::ivec2(1), glm::ivec2(n - 1));
        along_u = moved.point({inside.x + 1, inside.y}) - moved.point({inside.x - 1, inside.y});
      }
      const glm::vec3 tangent = glm::normalize(along_u - v.normal * glm::dot(along_u, v.normal));
      // The chart is laid out as the surface is seen from outside, u right and v down, nowhere mirrored.
      v.tangent = glm::vec4(tangent, -1);
    }
  return mesh;
}

}  // namespace lamina
