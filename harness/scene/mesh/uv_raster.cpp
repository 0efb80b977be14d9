// SPDX-License-Identifier: Apache-2.0
// Works on whole numbers, as hardware does, so that the edge rule is exact: Pineda, "A Parallel Algorithm for Polygon
// Rasterization", SIGGRAPH 1988.
#include "harness/scene/mesh/uv_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

constexpr int64_t steps = 256;  // positions within a texel, as Direct3D 11's 8 bits
struct Point {
  int64_t x, y;
};

// Twice the signed area of a, b, p; positive where p lies right of a to b with y down.
int64_t edge(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Centres on a left or top edge belong to the triangle (corners in positive order, y down).
bool owns_its_centres(Point a, Point b) { return b.y < a.y || (a.y == b.y && b.x > a.x); }

std::vector<uint32_t> texels_of(std::array<Point, 3> corner, int64_t side) {
  std::vector<uint32_t> texels;
  const int64_t area = edge(corner[0], corner[1], corner[2]);
  if (area == 0) return texels;
  if (area < 0) std::swap(corner[1], corner[2]);
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  const auto [top, bottom] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  const auto texel = [side](int64_t position) { return std::clamp<int64_t>(position / steps, 0, side - 1); };
  for (int64_t y = texel(top); y <= texel(bottom); ++y)
    for (int64_t x = texel(left); x <= texel(right); ++x) {
      const Point centre{x * steps + steps / 2, y * steps + steps / 2};
      bool inside = true;
      for (size_t i = 0; i < 3 && inside; ++i) {
        const Point a = corner[i], b = corner[(i + 1) % 3];
        inside = edge(a, b, centre) >= (owns_its_centres(a, b) ? 0 : 1);
      }
      if (inside) texels.push_back(static_cast<uint32_t>(y * side + x));
    }
  return texels;
}

}  // namespace

std::vector<uint32_t> covered_texels(const Mesh& mesh, size_t triangle, uint32_t side) {
  std::array<Point, 3> corner;
  for (size_t c = 0; c < 3; ++c) {
    const glm::dvec2 uv = glm::clamp(glm::dvec2(mesh.vertices[mesh.indices[3 * triangle + c]].uv), -1.0, 2.0);
    corner[c] = {std::llround(uv.x * double(side * steps)), std::llround(uv.y * double(side * steps))};
  }
  return texels_of(corner, side);
}

}  // namespace lamina
