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
// `drift` carries most of a point's last move into its next (Polyak's heavy ball, 1964), or far points would take thousands of rounds.
void spread(HeartGrid& grid, std::vector<glm::vec3>& drift, float keep, float growth) {
  static constexpr std::array<std::pair<int, int>, 8> around = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
  std::vector<glm::vec3> moved(grid.points.size());
  std::vector<float> crowd(grid.points.size());
  const float crowding = 30 * std::max(1 - growth / trunks_grown, 0.0f);
  for (size_t i = 0; i < crowd.size(); ++i) {
    const float away = crowding > 0 ? std::max(vessel_distance(grid.points[i]), 0.0f) / 0.12f : 0;
    crowd[i] = 1 + crowding * std::exp(-away * away);
  }
  for (int y = 0; y <= grid.cells; ++y)
    for (int x = 0; x <= grid.cells; ++x) {
      const glm::vec3 p = grid.point({x, y});
      glm::vec3 pull(0);
      float total = 0;
      for (const auto& [dx, dy] : around) {
        const glm::vec3 to = grid.point({x + dx, y + dy}) - p;
        // Stiffness grows with length squared; corners count half, being sqrt(2) as far in the square.
        const float weight = (dx != 0 && dy != 0 ? 0.25f : 1.0f) * (glm::dot(to, to) + 1e-8f) * 0.5f * (crowd[grid.index({x, y})] + crowd[grid.index(grid.fold({x + dx, y + dy}))]);
        pull += weight * to;
        total += weight;
      }
      // Six tenths of the way, for stability, and only along the surface: a vessel's tip, pulled inwards, would fall into the vessel.
      glm::vec3 move = pull * (0.6f / total) + keep * drift[grid.index({x, y})];
      const glm::vec3 across = glm::cross(grid.point({x, y + 1}) - grid.point({x, y - 1}), grid.point({x + 1, y}) - grid.point({x - 1, y}));
      const float area = glm::length(across);
      const glm::vec3 normal = across / std::max(area, 1e-12f);
      move -= normal * glm::dot(move, normal);
      // Near the surface the mesh's normal will do for bringing the point back, at a fourth of the gradient's cost.
      const float away = area > 1e-8f ? heart_distance(p + move, growth) : 1.0f;
      moved[grid.index({x, y})] = std::abs(away) < 0.003f ? p + move - normal * away : onto_heart(p + move, growth, 1);
      drift[grid.index({x, y})] = move;
    }
  grid.points = std::move(moved);
  sew(grid);
}

// Undoes small folds, which springs along the surface cannot: every point goes to the middle of its neighbours, then back to the
// surface along the shape's gradient.
void unfold(HeartGrid& grid, float growth) {
  std::vector<glm::vec3> moved(grid.points.size());
  for (int y = 0; y <= grid.cells; ++y)
    for (int x = 0; x <= grid.cells; ++x) {
      const glm::vec3 middle =
          0.25f * (grid.point({x + 1, y}) + grid.point({x - 1, y}) + grid.point({x, y + 1}) + grid.point({x, y - 1}));
      moved[grid.index({x, y})] = onto_heart(0.5f * (middle + grid.point({x, y})), growth, 1);
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
  // Numbers of rounds chosen by looking at the largest stretch, which more of them hardly change.
  const auto grow = [&grid](float from, float to, int steps, int rounds, float keep = 0) {
    std::vector<glm::vec3> drift(grid.points.size(), glm::vec3(0));
    for (int step = 1; step <= steps; ++step)
      for (int i = 0; i < rounds; ++i) spread(grid, drift, keep, from + (to - from) * static_cast<float>(step) / static_cast<float>(steps));
  };
  grow(0, 0, 1, 150, 0.8f);
  grow(0, trunks_grown, 60, 5);
  grow(trunks_grown, trunks_grown, 1, 150, 0.7f);
  grid = refined(grid);
  for (int i = 0; i < 12; ++i) unfold(grid, trunks_grown);
  grow(trunks_grown, branches_grown, 24, 4);
  grow(branches_grown, branches_grown, 1, 60, 0.7f);
  grid = refined(grid);
  grow(branches_grown, 1, 12, 1);
  grow(1, 1, 1, 12, 0.5f);
  for (int i = 0; i < 6; ++i) unfold(grid, 1);
  for (glm::vec3& p : grid.points) p = onto_heart(p, 1, 2);
  sew(grid);
  return grid;
}

// Every other point: what is drawn. The whole grid's triangles cover few pixels each in a frame of usual size, and a rasterizer that
// shades in blocks then spends most of its time outside them; the textures are made from the whole grid all the same.
HeartGrid thinned(const HeartGrid& fine) {
  HeartGrid coarse;
  coarse.cells = fine.cells / 2;
  for (int y = 0; y <= coarse.cells; ++y)
    for (int x = 0; x <= coarse.cells; ++x) coarse.points.push_back(fine.points[fine.index({2 * x, 2 * y})]);
  return coarse;
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
  const HeartGrid rest = thinned(heart_grid());
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
