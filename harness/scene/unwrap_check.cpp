// SPDX-License-Identifier: Apache-2.0
// The rasterizer works on whole numbers, as hardware does, so that the edge rule is exact: Pineda, "A Parallel Algorithm for Polygon
// Rasterization", SIGGRAPH 1988.
#include "harness/scene/unwrap_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

constexpr float tolerance = 1e-3f;  // of a tile; exporters round borders, and a texel of a 1024 texture is as wide
constexpr double worrying_overlap = 0.02;

struct Bounds {
  glm::vec2 low{INFINITY}, high{-INFINITY};
};
Bounds uv_bounds(const Mesh& mesh) {
  Bounds bounds;
  for (const uint32_t index : mesh.indices) {
    bounds.low = glm::min(bounds.low, mesh.vertices[index].uv);
    bounds.high = glm::max(bounds.high, mesh.vertices[index].uv);
  }
  return bounds;
}

constexpr int64_t raster_size = 512, steps = 256;  // texels on a side; positions within a texel, as Direct3D 11's 8 bits
struct Point {
  int64_t x, y;
};

// Twice the signed area of a, b, p; positive where p lies right of a to b with y down.
int64_t edge(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Centres on a left or top edge belong to the triangle (corners in positive order, y down).
bool owns_its_centres(Point a, Point b) { return b.y < a.y || (a.y == b.y && b.x > a.x); }

void count_texels(std::array<Point, 3> corner, std::vector<uint8_t>& counts) {
  const int64_t area = edge(corner[0], corner[1], corner[2]);
  if (area == 0) return;
  if (area < 0) std::swap(corner[1], corner[2]);
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  const auto [top, bottom] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  const auto texel = [](int64_t position) { return std::clamp<int64_t>(position / steps, 0, raster_size - 1); };
  for (int64_t y = texel(top); y <= texel(bottom); ++y)
    for (int64_t x = texel(left); x <= texel(right); ++x) {
      const Point centre{x * steps + steps / 2, y * steps + steps / 2};
      bool inside = true;
      for (size_t i = 0; i < 3 && inside; ++i) {
        const Point a = corner[i], b = corner[(i + 1) % 3];
        inside = edge(a, b, centre) >= (owns_its_centres(a, b) ? 0 : 1);
      }
      uint8_t& count = counts[static_cast<size_t>(y * raster_size + x)];
      if (inside && count < 2) ++count;
    }
}

}  // namespace

void move_to_unit_tile(Mesh& mesh) {
  const Bounds bounds = uv_bounds(mesh);
  glm::vec2 shift(0);
  for (int axis = 0; axis < 2; ++axis)
    if (bounds.low[axis] < -tolerance || bounds.high[axis] > 1 + tolerance) shift[axis] = std::floor(bounds.low[axis] + tolerance);
  if (shift == glm::vec2(0)) return;
  for (Vertex& vertex : mesh.vertices) vertex.uv -= shift;
}

std::string unwrap_problem(const Mesh& mesh) {
  const Bounds bounds = uv_bounds(mesh);
  const glm::vec2 span = bounds.high - bounds.low;
  if (span.x > 1 + 2 * tolerance || span.y > 1 + 2 * tolerance)
    return fmt::format("texture coordinates span {:.4g} x {:.4g} tiles; unwrap the mesh into one", span.x, span.y);
  if (bounds.low.x < -tolerance || bounds.low.y < -tolerance || bounds.high.x > 1 + tolerance || bounds.high.y > 1 + tolerance)
    return "texture coordinates cross the border of a tile; unwrap the mesh into one";
  return "";
}

double overlap_fraction(const Mesh& mesh) {
  std::vector<uint8_t> counts(raster_size * raster_size, 0);
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<Point, 3> corner;
    for (size_t c = 0; c < 3; ++c) {
      const glm::dvec2 uv = glm::clamp(glm::dvec2(mesh.vertices[mesh.indices[i + c]].uv), -1.0, 2.0);
      corner[c] = {std::llround(uv.x * double(raster_size * steps)), std::llround(uv.y * double(raster_size * steps))};
    }
    count_texels(corner, counts);
  }
  const auto covered = std::count_if(counts.begin(), counts.end(), [](uint8_t count) { return count > 0; });
  const auto twice = std::count(counts.begin(), counts.end(), uint8_t{2});
  return covered > 0 ? double(twice) / double(covered) : 0.0;
}

void settle_unwrap(Object& object, std::vector<std::string>& warnings) {
  move_to_unit_tile(object.mesh);
  object.unwrap_problem = unwrap_problem(object.mesh);
  if (!object.unwrap_problem.empty()) return;
  if (const double overlap = overlap_fraction(object.mesh); overlap > worrying_overlap)
    warnings.push_back(fmt::format("{:.1f}% of {}'s texture is used twice; the light map shows one of the lights there.",
                                   100 * overlap, object.name));
}

}  // namespace lamina
