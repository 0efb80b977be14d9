// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lamina {
namespace {

// Bits of x and y taken in turn: places near each other on the disc stay near each other in the order (Morton 1966).
uint32_t morton(float x, float y) {
  const auto spread = [](float value) {
    auto bits = static_cast<uint32_t>(std::clamp((value + 1) * 0.5f, 0.0f, 1.0f) * 65535.0f);
    bits = (bits | (bits << 8)) & 0x00ff00ffu;
    bits = (bits | (bits << 4)) & 0x0f0f0f0fu;
    bits = (bits | (bits << 2)) & 0x33333333u;
    return (bits | (bits << 1)) & 0x55555555u;
  };
  return spread(x) | (spread(y) << 1);
}

// `cosine(share)` is the i-th direction's cosine for its share (i + 1/2) / count.
template <class Cosine>
DirectionSet spiral(size_t count, Cosine&& cosine) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<glm::vec3> directions(count);
  for (size_t i = 0; i < count; ++i) {
    const double c = cosine((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    const double s = std::sqrt(std::max(0.0, 1 - c * c)), angle = golden_angle * static_cast<double>(i);
    directions[i] = glm::vec3(s * std::cos(angle), s * std::sin(angle), c);
  }
  std::vector<std::pair<uint32_t, size_t>> order(count);
  for (size_t i = 0; i < count; ++i) order[i] = {morton(directions[i].x, directions[i].y), i};
  std::sort(order.begin(), order.end());
  DirectionSet set;
  for (const auto& [key, i] : order) {
    set.x.push_back(directions[i].x);
    set.y.push_back(directions[i].y);
    set.z.push_back(directions[i].z);
  }
  return set;
}

// Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014: the mixing function of SplitMix64.
uint64_t mixed(uint64_t value) {
  value += 0x9e3779b97f4a7c15ull;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
  return value ^ (value >> 31);
}

}  // namespace

DirectionSet uniform_cap(size_t count, double lowest_cosine) {
  return spiral(count, [=](double share) { return 1 - share * (1 - lowest_cosine); });
}

DirectionSet cosine_hemisphere(size_t count) {
  return spiral(count, [](double share) { return std::sqrt(1 - share); });
}

glm::mat3 turned_frame(glm::vec3 axis, uint64_t seed, uint64_t index) {
  // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
  const float sign = std::copysign(1.0f, axis.z), a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
  const glm::vec3 x(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x), y(b, sign + axis.y * axis.y * a, -axis.y);
  const double turn = static_cast<double>(mixed(mixed(seed) ^ index) >> 11) * 0x1p-53 * 2 * std::numbers::pi;
  const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
  return {x * c + y * s, y * c - x * s, axis};
}

std::vector<std::vector<uint32_t>> touching_directions(const DirectionSet& set, size_t most) {
  const auto count = static_cast<uint32_t>(set.size());
  std::vector<uint32_t> by_height(count);
  std::iota(by_height.begin(), by_height.end(), 0u);
  std::sort(by_height.begin(), by_height.end(), [&](uint32_t a, uint32_t b) { return set.z[a] < set.z[b]; });
  // Of evenly spread directions the nearest six lie within two steps of the finest hexagonal grid.
  const float step = 2 * static_cast<float>(std::sqrt(2 * std::numbers::pi / count * 2 / std::sqrt(3.0)));
  std::vector<std::vector<uint32_t>> touching(count);
  for (uint32_t at = 0; at < count; ++at) {
    const uint32_t i = by_height[at];
    std::vector<std::pair<float, uint32_t>> near;
    const auto consider = [&](uint32_t j) {
      const float chord = glm::length(set[i] - set[j]);
      if (chord < step) near.emplace_back(chord, j);
    };
    for (uint32_t other = at; other-- > 0 && set.z[i] - set.z[by_height[other]] < step;) consider(by_height[other]);
    for (uint32_t other = at + 1; other < count && set.z[by_height[other]] - set.z[i] < step; ++other)
      consider(by_height[other]);
    std::sort(near.begin(), near.end());
    for (size_t k = 0; k < std::min(most, near.size()); ++k) touching[i].push_back(near[k].second);
  }
  return touching;
}

}  // namespace lamina
