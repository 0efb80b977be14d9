// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/kept_coverage.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

double covered_with(const std::vector<std::byte>& level, double scale, double cutoff) {
  size_t covered = 0;
  for (size_t at = 3; at < level.size(); at += 4) covered += std::to_integer<int>(level[at]) * scale >= cutoff * 255;
  return static_cast<double>(covered) / static_cast<double>(level.size() / 4);
}

}  // namespace

double alpha_coverage(const TextureImage& texture, size_t level, double cutoff) {
  return covered_with(texture.levels[level], 1, cutoff);
}

TextureImage with_kept_coverage(const TextureImage& texture, double cutoff) {
  TextureImage kept = texture;
  kept.name += ", coverage kept";
  const double wanted = alpha_coverage(texture, 0, cutoff);
  for (size_t level = 1; level < kept.levels.size() && wanted > 0; ++level) {
    std::vector<std::byte>& texels = kept.levels[level];
    double low = 0, high = 64;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (covered_with(texels, middle, cutoff) < wanted ? low : high) = middle;
    }
    // Of the two nearest coverages, the nearer: levels of few texels have few.
    const double scale = wanted - covered_with(texels, low, cutoff) < covered_with(texels, high, cutoff) - wanted ? low : high;
    for (size_t at = 3; at < texels.size(); at += 4)
      texels[at] = static_cast<std::byte>(std::lround(std::min(std::to_integer<int>(texels[at]) * scale, 255.0)));
  }
  return kept;
}

}  // namespace lamina
