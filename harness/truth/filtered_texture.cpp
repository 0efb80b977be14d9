// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/filtered_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

int wrapped(int at, uint32_t size, Wrap wrap) {
  const int count = static_cast<int>(size);
  if (at >= 0 && at < count) return at;
  const int period = wrap == Wrap::mirror ? 2 * count : count;
  if (wrap == Wrap::clamp) return std::clamp(at, 0, count - 1);
  const int repeated = ((at % period) + period) % period;
  return repeated < count ? repeated : period - 1 - repeated;
}

}  // namespace

FilteredTexture::FilteredTexture(const TextureImage& texture) {
  for (size_t level = 0; level < texture.levels.size(); ++level) levels_.push_back(level_texels(texture, level));
}

glm::dvec4 FilteredTexture::bilinear(const Texels& level, glm::dvec2 uv) {
  const double x = uv.x * level.width - 0.5, y = uv.y * level.height - 0.5, left = std::floor(x), top = std::floor(y);
  const TextureWraps wraps = level.wraps.value_or(TextureWraps{});
  const auto two = [](double first, uint32_t size, Wrap wrap) {
    return std::array{size_t(wrapped(static_cast<int>(first), size, wrap)),
                      size_t(wrapped(static_cast<int>(first) + 1, size, wrap))};
  };
  const std::array<size_t, 2> columns = two(left, level.width, wraps.u), rows = two(top, level.height, wraps.v);
  const auto texel = [&](int dx, int dy) {
    return glm::dvec4(level.rgba[rows[size_t(dy)] * level.width + columns[size_t(dx)]]);
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
