// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/unwrap_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/core/bytes.h"
#include "harness/core/text.h"
#include "harness/scene/mesh/triangle_areas.h"
#include "harness/scene/mesh/uv_raster.h"

namespace lamina {
namespace {

constexpr float tolerance = tile_tolerance;

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

}  // namespace

void move_to_unit_tile(Mesh& mesh) {
  const Bounds bounds = uv_bounds(mesh);
  glm::vec2 shift(0);
  for (int axis = 0; axis < 2; ++axis)
    if (bounds.low[axis] < -tolerance || bounds.high[axis] > 1 + tolerance)
      shift[axis] = std::floor(bounds.low[axis] + tolerance);
  if (shift == glm::vec2(0)) return;
  for (Vertex& vertex : mesh.vertices) vertex.uv -= shift;
}

double share_without_texels(const Mesh& mesh) {
  constexpr double min_of_even = 1e-4;
  std::vector<TriangleAreas> areas;
  double surface = 0, unwrapped = 0;
  for (size_t i = 0; i < mesh.indices.size() / 3; ++i) {
    areas.push_back(doubled_areas(mesh, i));
    surface += areas.back().surface, unwrapped += areas.back().unwrapped;
  }
  if (!(unwrapped > 0)) return 1;
  double without = 0;
  for (const TriangleAreas& triangle : areas)
    if (triangle.unwrapped * surface < min_of_even * triangle.surface * unwrapped) without += triangle.surface;
  return surface > 0 ? without / surface : 0;
}

std::string unwrap_problem(const Mesh& mesh) {
  const Bounds bounds = uv_bounds(mesh);
  const glm::vec2 span = bounds.high - bounds.low;
  if (span == glm::vec2(0)) return "it has no texture coordinates, or all of them are one point; unwrap the mesh";
  if (span.x > 1 + 2 * tolerance || span.y > 1 + 2 * tolerance)
    return fmt::format("texture coordinates span {:.4g} x {:.4g} tiles; unwrap the mesh into one", span.x, span.y);
  if (bounds.low.x < -tolerance || bounds.low.y < -tolerance || bounds.high.x > 1 + tolerance || bounds.high.y > 1 + tolerance)
    return "texture coordinates cross the border of a tile; unwrap the mesh into one";
  if (const double share = share_without_texels(mesh); share > max_share_without_texels)
    return fmt::format(
        "texture coordinates have no area on {:.3g}% of its surface; unwrap the mesh so that every face has texels",
        100 * share);
  return "";
}

double overlap_fraction(const Mesh& mesh) {
  std::vector<uint8_t> counts(uv_raster_size * uv_raster_size, 0);
  for (size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle)
    for (const uint32_t texel : covered_texels(mesh, triangle)) counts[texel] = std::min<uint8_t>(counts[texel] + 1, 2);
  const auto covered = std::count_if(counts.begin(), counts.end(), [](uint8_t count) { return count > 0; });
  const auto twice = std::count(counts.begin(), counts.end(), uint8_t{2});
  return covered > 0 ? double(twice) / double(covered) : 0.0;
}

bool pictures_repeat(const Object& object) {
  for (const auto& [effect, values] : object.effects)
    for (const auto& [name, texture] : values.textures)
      if (texture && texture->wraps) return false;
  return true;
}

double OverlapFractions::of(const Mesh& mesh) {
  std::vector<glm::vec2> uvs;
  uvs.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) uvs.push_back(vertex.uv);
  const auto [entry, fresh] = known_.try_emplace(hash_hex(bytes_of(uvs)) + hash_hex(bytes_of(mesh.indices)));
  if (fresh) entry->second = overlap_fraction(mesh);
  return entry->second;
}

std::string overlap_warning(const Object& object, OverlapFractions& overlaps) {
  if (!object.unwrap_problem.empty()) return "";
  const double overlap = overlaps.of(object.mesh);
  if (overlap <= worrying_overlap) return "";
  return fmt::format("{:.1f}% of {}'s texture is used twice; a map over its unwrap holds what is true of one use.",
                     100 * overlap, object.name);
}

}  // namespace lamina
