// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/filtered_texture.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

float decoded_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

int wrapped(int at, int size) { return ((at % size) + size) % size; }

}  // namespace

FilteredTexture::FilteredTexture(const TextureImage& texture) {
  int width = static_cast<int>(texture.width), height = static_cast<int>(texture.height);
  for (const std::vector<std::byte>& bytes : texture.levels) {
    Level& level = levels_.emplace_back(Level{width, height, std::vector<glm::vec4>(bytes.size() / 4)});
    for (size_t i = 0; i < bytes.size(); ++i) {
      const float value = static_cast<float>(std::to_integer<int>(bytes[i])) / 255;
      level.texels[i / 4][static_cast<int>(i % 4)] =
          texture.format == Format::rgba8_srgb && i % 4 < 3 ? decoded_srgb(value) : value;
    }
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
  }
}

glm::dvec4 FilteredTexture::bilinear(const Level& level, glm::dvec2 uv) {
  const double x = uv.x * level.width - 0.5, y = uv.y * level.height - 0.5, left = std::floor(x), top = std::floor(y);
  const auto texel = [&](int dx, int dy) {
    const int column = wrapped(static_cast<int>(left) + dx, level.width),
              row = wrapped(static_cast<int>(top) + dy, level.height);
    return glm::dvec4(level.texels[size_t(row) * size_t(level.width) + size_t(column)]);
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), x - left), glm::mix(texel(0, 1), texel(1, 1), x - left), y - top);
}

glm::dvec4 FilteredTexture::at(glm::dvec2 uv, glm::dvec2 right, glm::dvec2 down) const {
  const glm::dvec2 size(levels_.front().width, levels_.front().height);
  const double widest = std::max(glm::length((right - uv) * size), glm::length((down - uv) * size));
  const double level = std::clamp(widest > 0 ? std::log2(widest) : 0, 0.0, static_cast<double>(levels_.size() - 1));
  const auto finer = static_cast<size_t>(level);
  const glm::dvec4 fine = bilinear(levels_[finer], uv);
  if (finer + 1 >= levels_.size() || level == std::floor(level)) return fine;
  return glm::mix(fine, bilinear(levels_[finer + 1], uv), level - std::floor(level));
}

}  // namespace lamina
