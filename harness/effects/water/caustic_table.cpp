// SPDX-License-Identifier: Apache-2.0
// See caustic_table.h.
#include "harness/effects/water/caustic_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>
#include <numbers>
#include <numeric>
#include <vector>

namespace lamina {
namespace {

constexpr int side = static_cast<int>(caustic_side);

int wrapped(int i) { return ((i % side) + side) % side; }

// Half floats of one or two channels, each level the 2x2 means of the one before.
TextureImage with_mips(std::string name, Format format, std::vector<float> level) {
  TextureImage image;
  image.name = std::move(name);
  image.format = format;
  image.width = image.height = caustic_side;
  const size_t channels = level.size() / (size_t(side) * side);
  for (size_t width = caustic_side;; width /= 2) {
    std::vector<uint16_t> halves;
    for (const float value : level) halves.push_back(glm::packHalf1x16(value));
    std::vector<std::byte>& bytes = image.levels.emplace_back(halves.size() * sizeof(halves[0]));
    std::memcpy(bytes.data(), halves.data(), bytes.size());
    if (width == 1) return image;
    std::vector<float> next;
    for (size_t y = 0; y < width; y += 2)
      for (size_t x = 0; x < width; x += 2)
        for (size_t c = 0; c < channels; ++c) {
          const auto at = [&](size_t column, size_t row) { return level[(row * width + column) * channels + c]; };
          next.push_back((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4);
        }
    level = std::move(next);
  }
}

// The mean of the lesser of two texels of a level of two half floats, by their first, where one does not follow the other:
// sorted, the texel i of n is the lesser of the 2 (n - i) - 1 pairs with itself and those after it.
double mean_of_lesser(const std::vector<std::byte>& level) {
  std::vector<double> values;
  for (size_t i = 0; i < level.size(); i += 4) {
    uint16_t half = 0;
    std::memcpy(&half, &level[i], 2);
    values.push_back(double(glm::unpackHalf1x16(half)));
  }
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (size_t i = 0; i < values.size(); ++i) sum += values[i] * (2 * (n - static_cast<double>(i)) - 1) / (n * n);
  return sum;
}

}  // namespace

TextureImage make_caustic_table() {
  // Whole waves across the tile, of about as many directions as wind waves have; amplitudes fall as the square of the number.
  struct Sine {
    glm::ivec2 waves;
    double turn;
  };
  constexpr Sine sines[] = {{{2, 1}, 0.3},  {{-1, 3}, 2.1}, {{3, -2}, 4.4}, {{1, 4}, 1.2},  {{4, 2}, 5.6},
                            {{-3, 4}, 3.3}, {{5, -1}, 0.9}, {{2, 5}, 2.7},  {{-5, 3}, 4.9}, {{6, 2}, 1.7}};
  constexpr double bend = 0.0105;  // of the tile: how far a slope's ray lands away, so that light is just brought to focus
  constexpr int rays = 2 * side;
  std::vector<float> light(size_t(side) * side);
  for (int row = 0; row < rays; ++row)
    for (int column = 0; column < rays; ++column) {
      const glm::dvec2 at = (glm::dvec2(column, row) + 0.5) / double(rays);
      glm::dvec2 slope(0);
      for (const Sine& sine : sines) {
        const glm::dvec2 k(sine.waves);
        slope += k / glm::dot(k, k) * std::cos(2 * std::numbers::pi * glm::dot(k, at) + sine.turn);
      }
      const glm::dvec2 lands = (at - bend * 2.4 * slope) * double(side) - 0.5, low = glm::floor(lands), share = lands - low;
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x)
          light[size_t(wrapped(int(low.y) + y)) * side + size_t(wrapped(int(low.x) + x))] +=
              static_cast<float>((x != 0 ? share.x : 1 - share.x) * (y != 0 ? share.y : 1 - share.y) / 4);
    }
  std::vector<float> beside_its_mean;
  for (const float value : light) beside_its_mean.push_back(value), beside_its_mean.push_back(0);
  TextureImage table = with_mips("caustic_table", Format::rg16_float, std::move(beside_its_mean));
  const double as_texels = 1 - mean_of_lesser(table.levels.front());
  for (std::vector<std::byte>& level : table.levels) {
    const double mean = 1 - (1 - mean_of_lesser(level)) * (1 - caustic_lesser_mean) / as_texels;
    const uint16_t half = glm::packHalf1x16(static_cast<float>(mean));
    for (size_t i = 2; i < level.size(); i += 4) std::memcpy(&level[i], &half, 2);
  }
  return table;
}

TextureImage make_foam_table() {
  // Distances to the nearest of random points, at two scales; then ranked.
  constexpr int cells = 16;
  const auto point_in = [](int x, int y) {
    const auto u = static_cast<uint32_t>(((x % cells) + cells) % cells),
               v = static_cast<uint32_t>(((y % cells) + cells) % cells);
    uint32_t h = (u * 73856093u) ^ (v * 19349663u) ^ 83492791u;
    h ^= h >> 16, h *= 0x85ebca6bu, h ^= h >> 13, h *= 0xc2b2ae35u, h ^= h >> 16;
    return glm::dvec2(double(h & 0xffffu), double(h >> 16)) / 65536.0;
  };
  std::vector<float> noise;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      double sum = 0;
      for (const int scale : {1, 2}) {
        const glm::dvec2 at = glm::dvec2(column, row) / double(side) * double(cells) * double(scale);
        double nearest = 9;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int x = int(std::floor(at.x)) + dx, y = int(std::floor(at.y)) + dy;
            nearest = std::min(nearest, glm::distance(at, glm::dvec2(x, y) + point_in(x + scale * 7, y)));
          }
        sum += nearest / scale;
      }
      noise.push_back(static_cast<float>(sum));
    }
  std::vector<size_t> order(noise.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return noise[a] > noise[b]; });
  for (size_t rank = 0; rank < order.size(); ++rank)
    noise[order[rank]] = (static_cast<float>(rank) + 0.5f) / static_cast<float>(order.size());
  return with_mips("foam_table", Format::r16_float, std::move(noise));
}

TextureImage make_ripple_table() {
  // Waves of all directions, 3 to 19 across the tile; heights fall so that each octave has about as much slope.
  std::vector<glm::dvec2> slopes(size_t(side) * side, glm::dvec2(0));
  uint32_t state = 12345;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  for (int i = 0; i < 24; ++i) {
    const double turn = 2 * std::numbers::pi * random() / double(1 << 24), waves = 3 * std::pow(6.3, i / 23.0);
    const glm::dvec2 k = glm::round(waves * glm::dvec2(std::cos(turn), std::sin(turn)));
    const double phase = 2 * std::numbers::pi * random() / double(1 << 24);
    if (k == glm::dvec2(0)) continue;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        slopes[size_t(row) * side + size_t(column)] +=
            k / glm::length(k) * std::cos(2 * std::numbers::pi * (k.x * column + k.y * row) / side + phase);
  }
  glm::dvec2 squares(0);
  for (const glm::dvec2& slope : slopes) squares += slope * slope / double(slopes.size());
  std::vector<float> level;
  for (const glm::dvec2& slope : slopes)
    level.push_back(static_cast<float>(slope.x / std::sqrt(squares.x))),
        level.push_back(static_cast<float>(slope.y / std::sqrt(squares.y)));
  return with_mips("ripple_table", Format::rg16_float, std::move(level));
}

}  // namespace lamina
