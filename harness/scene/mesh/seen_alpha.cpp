// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/seen_alpha.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

using Triangle = std::array<glm::dvec2, 3>;  // in texels

// Separating axes of a triangle and the square of half-side 1 around `centre`, the axes of the square itself being settled by
// the caller's bounds (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996, section 5, in the plane). A triangle without area
// is its edges' segment or point, which the same axes settle.
bool touches(const Triangle& triangle, glm::dvec2 centre) {
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 edge = triangle[(i + 1) % 3] - triangle[i];
    const glm::dvec2 across(-edge.y, edge.x);
    const double reach = std::abs(across.x) + std::abs(across.y);
    double lowest = 1e300, highest = -1e300;
    for (const glm::dvec2& corner : triangle) {
      const double along = glm::dot(across, corner - centre);
      lowest = std::min(lowest, along);
      highest = std::max(highest, along);
    }
    if (lowest > reach || highest < -reach) return false;
  }
  return true;
}

uint8_t alpha(const TextureImage& texture, int64_t x, int64_t y) {
  return std::to_integer<uint8_t>(texture.levels[0][(static_cast<size_t>(y) * texture.width + static_cast<size_t>(x)) * 4 + 3]);
}

// The texels that stand for one beyond the border: of every wrap mode.
uint8_t wrapped_alpha(const TextureImage& texture, int64_t x, int64_t y) {
  const int64_t width = texture.width, height = texture.height;
  const uint8_t clamped = alpha(texture, std::clamp<int64_t>(x, 0, width - 1), std::clamp<int64_t>(y, 0, height - 1));
  const auto repeated = [](int64_t at, int64_t size) { return ((at % size) + size) % size; };
  if (!texture.wraps) return std::max(clamped, alpha(texture, repeated(x, width), repeated(y, height)));
  const auto wrapped = [&](int64_t at, int64_t size, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp<int64_t>(at, 0, size - 1);
    if (wrap == Wrap::repeat) return repeated(at, size);
    const int64_t twice = repeated(at, 2 * size);
    return std::min(twice, 2 * size - 1 - twice);
  };
  return alpha(texture, wrapped(x, width, texture.wraps->u), wrapped(y, height, texture.wraps->v));
}

uint8_t greatest_alpha(const TextureImage& texture) {
  uint8_t greatest = 0;
  for (size_t i = 3; i < texture.levels[0].size(); i += 4)
    greatest = std::max(greatest, std::to_integer<uint8_t>(texture.levels[0][i]));
  return greatest;
}

}  // namespace

float seen_alpha(const Mesh& mesh, const TextureImage& texture) {
  const uint8_t greatest = greatest_alpha(texture);
  const glm::dvec2 size(texture.width, texture.height);
  uint8_t seen = 0;
  for (size_t i = 0; i + 2 < mesh.indices.size() && seen < greatest; i += 3) {
    Triangle triangle;
    for (size_t corner = 0; corner < 3; ++corner)
      triangle[corner] = glm::dvec2(mesh.vertices[mesh.indices[i + corner]].uv) * size;
    const glm::dvec2 lowest = glm::min(triangle[0], glm::min(triangle[1], triangle[2]));
    const glm::dvec2 highest = glm::max(triangle[0], glm::max(triangle[1], triangle[2]));
    const glm::dvec2 span = highest - lowest, furthest = glm::max(glm::abs(lowest), glm::abs(highest));
    constexpr double far_away = 1e15;  // doubles hold whole texels up to here
    if (!(span.x <= 2 * size.x && span.y <= 2 * size.y && furthest.x < far_away && furthest.y < far_away))
      return float(greatest) / 255;
    // Texel x has its centre at x + 0.5; the open interval of one texel on both sides decides.
    const auto first_x = static_cast<int64_t>(std::floor(lowest.x - 1.5)) + 1,
               first_y = static_cast<int64_t>(std::floor(lowest.y - 1.5)) + 1;
    const auto last_x = static_cast<int64_t>(std::ceil(highest.x + 0.5)) - 1,
               last_y = static_cast<int64_t>(std::ceil(highest.y + 0.5)) - 1;
    for (int64_t y = first_y; y <= last_y; ++y)
      for (int64_t x = first_x; x <= last_x; ++x) {
        const uint8_t here = wrapped_alpha(texture, x, y);
        if (here > seen && touches(triangle, {double(x) + 0.5, double(y) + 0.5})) seen = here;
      }
  }
  return float(seen) / 255;
}

float settle_seen_alpha(const Mesh& mesh, Texture& texture) {
  const float seen = seen_alpha(mesh, *texture);
  if (seen > 0 || greatest_alpha(*texture) == 0) return seen;
  // Levels are filtered channel by channel, so clearing alpha in each is the same as filtering a base whose alpha is cleared.
  auto cleared = std::make_shared<TextureImage>(*texture);
  for (std::vector<std::byte>& level : cleared->levels)
    for (size_t i = 3; i < level.size(); i += 4) level[i] = std::byte{0};
  texture = std::move(cleared);
  return seen;
}

}  // namespace lamina
