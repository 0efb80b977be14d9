// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/marble.h"

#include <array>
#include <cmath>
#include <numeric>

#include "harness/scene/made/noise.h"

namespace lamina {
namespace {

// Perlin's permutation: a lattice point's hash in two look-ups, quick enough for millions of texels.
std::array<uint8_t, 256> shuffled_bytes() {
  std::array<uint8_t, 256> bytes;
  std::iota(bytes.begin(), bytes.end(), uint8_t{0});
  Random random(256);
  for (uint32_t left = 256; left > 1; --left) std::swap(bytes[left - 1], bytes[random.below(left)]);
  return bytes;
}

// About -1 to 1, zero at lattice points; one lattice cell is one unit of `p`, and the lattice repeats after `period` cells,
// over one period around the first.
float noise(glm::vec2 p, int period, uint32_t seed) {
  static const std::array<uint8_t, 256> permutation = shuffled_bytes();
  constexpr float diagonal = 0.70710678f;
  static constexpr std::array<std::array<float, 2>, 8> gradients = {{{1, 0},
                                                                     {-1, 0},
                                                                     {0, 1},
                                                                     {0, -1},
                                                                     {diagonal, diagonal},
                                                                     {-diagonal, diagonal},
                                                                     {diagonal, -diagonal},
                                                                     {-diagonal, -diagonal}}};
  // No floor() and no division: this runs tens of times a texel.
  const auto cell = [](float position) { return static_cast<int>(position) - (position < 0); };
  const auto wrapped = [period](int i) { return i < 0 ? i + period : i >= period ? i - period : i; };
  const int cell_x = cell(p.x), cell_y = cell(p.y);
  const float x = p.x - float(cell_x), y = p.y - float(cell_y);
  const int left = wrapped(cell_x), right = wrapped(cell_x + 1), top = wrapped(cell_y), bottom = wrapped(cell_y + 1);
  const auto corner = [&](int column, int row, float dx, float dy) {
    const uint32_t hash = permutation[(permutation[(column + seed) & 255u] + row + (seed >> 8)) & 255u];
    const std::array<float, 2>& gradient = gradients[hash & 7u];
    return gradient[0] * dx + gradient[1] * dy;
  };
  const auto fade = [](float t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const float fade_x = fade(x), fade_y = fade(y);
  const float above = glm::mix(corner(left, top, x, y), corner(right, top, x - 1, y), fade_x);
  const float below = glm::mix(corner(left, bottom, x, y - 1), corner(right, bottom, x - 1, y - 1), fade_x);
  return 1.4142136f * glm::mix(above, below, fade_y);  // unit gradients in the plane reach sqrt(1/2)
}

// Octaves of noise over the unit square, each twice as fine and half as strong.
float octaves(glm::vec2 uv, int period, int count, uint32_t seed) {
  float sum = 0, strength = 0.5f;
  for (int i = 0; i < count; ++i, period *= 2, strength *= 0.5f)
    sum += strength * noise(uv * float(period), period, seed + 59u * static_cast<uint32_t>(i));
  return sum;
}

// 1 along the lines where noise changes sign, falling to 0 within `width` of noise: threads, which swell and fade along their
// way.
float veins(glm::vec2 uv, int period, float width, uint32_t seed) {
  const float distance = std::abs(octaves(uv, period, 2, seed));
  const float swell = glm::smoothstep(-0.25f, 0.35f, noise(uv * float(period), period, seed + 7));
  return swell * (1 - glm::smoothstep(0.0f, width * (0.3f + swell), distance));
}

// Chosen by eye, in linear light.
constexpr glm::vec3 deep_red{0.22f, 0.022f, 0.014f}, flesh{0.74f, 0.25f, 0.15f}, fat{0.93f, 0.68f, 0.40f},
    jade{0.13f, 0.30f, 0.17f}, vein_red{0.14f, 0.005f, 0.009f}, vein_blue{0.05f, 0.07f, 0.15f};

glm::vec3 marble_at(glm::vec2 uv, uint32_t seed) {
  const glm::vec2 moved_by(octaves(uv, 3, 3, seed + 1), octaves(uv, 3, 3, seed + 2));
  const glm::vec2 moved = uv + 0.16f * moved_by;
  const float tone = octaves(moved, 4, 5, seed + 3);
  glm::vec3 colour = glm::mix(deep_red, flesh, glm::smoothstep(-0.42f, 0.22f, tone));
  colour = glm::mix(colour, jade, 0.85f * glm::smoothstep(0.06f, 0.36f, octaves(moved, 2, 3, seed + 4)));
  // Pale bands where the tone passes a few values, as layers of stone or fat do.
  const float band = std::abs(std::sin(9.0f * tone + 2.0f * moved_by.x));
  colour = glm::mix(colour, fat, 0.5f * (1 - glm::smoothstep(0.0f, 0.45f, band)));
  const glm::vec2 wandering = uv + 0.09f * moved_by;
  colour = glm::mix(colour, vein_blue, 0.7f * veins(wandering, 8, 0.05f, seed + 5));
  return glm::mix(colour, vein_red, 0.9f * veins(wandering, 4, 0.045f, seed + 6));
}

}  // namespace

Texels marble(uint32_t width, uint32_t height, uint32_t seed) {
  Texels result{width, height, std::vector<glm::vec4>(size_t{width} * height)};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      result.rgba[size_t{y} * width + x] =
          glm::vec4(marble_at({(float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height)}, seed), 1.0f);
  return result;
}

}  // namespace lamina
