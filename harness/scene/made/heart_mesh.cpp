// SPDX-License-Identifier: Apache-2.0
// See heart_mesh.h.
#include "harness/scene/made/heart_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/scene/made/heart_rows.h"
#include "harness/scene/made/heart_shape.h"
#include "harness/scene/made/kept.h"

namespace lamina {
namespace {

// The middle of the chart looks to the front, a little to the left and up; up runs along the square's diagonal, so that the
// four folds' middles, where the unwrap is pinched, lie off the silhouette's top and bottom.
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

// The shape's part in one round of spreading.
struct Round {
  float growth = 1;  // of the shape
  float keep = 0;    // share of a point's last move that goes into its next (Polyak's heavy ball, 1964): far points come faster
};

// One round of springs: every point moves along the surface towards its eight neighbours, the farther ones pulling harder.
// `drift` holds the points' last moves.
void spread(HeartGrid& grid, std::vector<glm::vec3>& drift, const Round& round) {
  static constexpr std::array<glm::ivec2, 8> around = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
  // Springs near where vessels will grow are stiffer at first: points gather there that the vessels will need. The crowd thins
  // out over 12 cm.
  const float crowding = 30 * std::max(1 - round.growth / trunks_grown, 0.0f);
  std::vector<float> stiffness(grid.points.size(), 1.0f);
  if (crowding > 0)
    for (size_t i = 0; i < stiffness.size(); ++i) {
      const float away = std::max(vessel_distance(grid.points[i], 0.4f), 0.0f) / 0.12f;
      stiffness[i] += crowding * std::exp(-away * away);
    }
  std::vector<glm::vec3> moved(grid.points.size());
  each_row(static_cast<uint32_t>(grid.cells + 1), [&](uint32_t row) {
    for (int x = 0; x <= grid.cells; ++x) {
      const glm::ivec2 at(x, static_cast<int>(row));
      const size_t i = grid.index(at);
      const glm::vec3 p = grid.points[i];
      glm::vec3 pull(0);
      float total = 0;
      for (const glm::ivec2 step : around) {
        const size_t neighbour = grid.index(grid.fold(at + step));
        const glm::vec3 to = grid.points[neighbour] - p;
        // Stiffness grows with length squared; corners count a quarter, being sqrt(2) as far in the square, to the fourth
        // power.
        const float weight =
            (step.x != 0 && step.y != 0 ? 0.25f : 1.0f) * (stiffness[i] + stiffness[neighbour]) * (glm::dot(to, to) + 1e-8f);
        pull += weight * to;
        total += weight;
      }
      // Six tenths of the way, for stability, and only along the surface: a vessel's tip, pulled inwards, would fall into the
      // vessel.
      glm::vec3 move = pull * (0.6f / total) + round.keep * drift[i];
      const glm::vec3 across = glm::cross(grid.point(at + glm::ivec2(0, 1)) - grid.point(at - glm::ivec2(0, 1)),
                                          grid.point(at + glm::ivec2(1, 0)) - grid.point(at - glm::ivec2(1, 0)));
      const float area = glm::length(across);
      const glm::vec3 normal = across / std::max(area, 1e-12f);
      move -= normal * glm::dot(move, normal);
      // Near the surface the mesh's normal will do for bringing the point back, at a fourth of the gradient's cost. In a fold's
      // middle the mesh has none.
      const float away = area > 1e-8f ? heart_distance(p + move, round.growth) : 1.0f;
      moved[i] = std::abs(away) < 0.003f ? p + move - normal * away : onto_heart(p + move, round.growth, 1);
      drift[i] = move;
    }
  });
  grid.points = std::move(moved);
  sew(grid);
}

// Undoes small folds, which springs along the surface cannot: every point goes to the middle of its neighbours, then back to
// the surface along the shape's gradient.
void unfold(HeartGrid& grid, float growth) {
  std::vector<glm::vec3> moved(grid.points.size());
  each_row(static_cast<uint32_t>(grid.cells + 1), [&](uint32_t row) {
    for (int x = 0; x <= grid.cells; ++x) {
      const glm::ivec2 at(x, static_cast<int>(row));
      const glm::vec3 middle = 0.25f * (grid.point(at + glm::ivec2(1, 0)) + grid.point(at - glm::ivec2(1, 0)) +
                                        grid.point(at + glm::ivec2(0, 1)) + grid.point(at - glm::ivec2(0, 1)));
      moved[grid.index(at)] = onto_heart(0.5f * (middle + grid.point(at)), growth, 1);
    }
  });
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
      fine.points[fine.index({x, y})] =
          0.25f * (coarse.point(low) + coarse.point({high.x, low.y}) + coarse.point({low.x, high.y}) + coarse.point(high));
    }
  sew(fine);
  return fine;
}

// Lets the shape grow from one state to another in equal steps, with rounds of spreading after each.
struct Growth {
  float from, to;
  int steps, rounds;
  float keep;
};
void grow(HeartGrid& grid, const Growth& g) {
  std::vector<glm::vec3> drift(grid.points.size(), glm::vec3(0));
  for (int step = 1; step <= g.steps; ++step)
    for (int i = 0; i < g.rounds; ++i)
      spread(grid, drift, {g.from + (g.to - g.from) * static_cast<float>(step) / static_cast<float>(g.steps), g.keep});
}

HeartGrid make_grid() {
  HeartGrid grid;
  grid.cells = 44;
  const float n = static_cast<float>(grid.cells);
  for (int y = 0; y <= grid.cells; ++y)
    for (int x = 0; x <= grid.cells; ++x)
      grid.points.push_back(cast_out(chart_direction(2 * static_cast<float>(x) / n - 1, 1 - 2 * static_cast<float>(y) / n)));
  sew(grid);
  // Steps and rounds as few as keep the mesh without tangles where vessels meet and branches at their full length; vessels that
  // grow faster than points follow collapse.
  grow(grid, {0, 0, 1, 100, 0.8f});
  grow(grid, {0, trunks_grown, 60, 4, 0});
  grow(grid, {trunks_grown, trunks_grown, 1, 120, 0.7f});
  // 88 cells a side make 15,488 triangles of some 30 pixels each where the heart fills a frame of usual size: smaller ones
  // leave a rasterizer that shades in blocks mostly outside of them.
  grid = refined(grid);
  for (int i = 0; i < 12; ++i) unfold(grid, trunks_grown);
  grow(grid, {trunks_grown, branches_grown, 30, 4, 0});
  grow(grid, {branches_grown, branches_grown, 1, 60, 0.7f});
  grow(grid, {branches_grown, 1, 12, 1, 0});
  grow(grid, {1, 1, 1, 12, 0.5f});
  for (int i = 0; i < 4; ++i) unfold(grid, 1);
  for (glm::vec3& p : grid.points) p = onto_heart(p, 1, 2);
  sew(grid);
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
  static const HeartGrid made = [] {
    const Parts parts = kept("heart_grid", [] {
      const HeartGrid grid = make_grid();
      return Parts{std::string(bytes_of(grid.cells)), std::string(bytes_of(grid.points))};
    });
    return HeartGrid{values_in<int>(parts[0]).front(), values_in<glm::vec3>(parts[1])};
  }();
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
      // Differences reach across seams, so that both sides agree. In a fold's middle they vanish: there the row inside stands
      // in.
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
