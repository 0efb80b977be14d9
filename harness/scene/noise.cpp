// SPDX-License-Identifier: Apache-2.0
// See noise.h.
#include "harness/scene/noise.h"

#include <array>
#include <cmath>

namespace lamina {
namespace {

// MurmurHash3's 32-bit finalizer: every input bit reaches every output bit.
uint32_t mix(uint32_t h) {
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  h ^= h >> 16;
  return h;
}

// The top 24 bits, as many as a float holds exactly.
float unit_interval(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

// Perlin's twelve directions to the edges of a cube, four of them twice to make sixteen.
float dot_gradient(uint32_t hash, glm::vec3 d) {
  static constexpr std::array<std::array<int8_t, 3>, 16> directions = {{{1, 1, 0},
                                                                        {-1, 1, 0},
                                                                        {1, -1, 0},
                                                                        {-1, -1, 0},
                                                                        {1, 0, 1},
                                                                        {-1, 0, 1},
                                                                        {1, 0, -1},
                                                                        {-1, 0, -1},
                                                                        {0, 1, 1},
                                                                        {0, -1, 1},
                                                                        {0, 1, -1},
                                                                        {0, -1, -1},
                                                                        {1, 1, 0},
                                                                        {-1, 1, 0},
                                                                        {0, -1, 1},
                                                                        {0, -1, -1}}};
  const auto& g = directions[hash >> 28];
  return d.x * static_cast<float>(g[0]) + d.y * static_cast<float>(g[1]) + d.z * static_cast<float>(g[2]);
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

uint32_t hash_lattice(glm::ivec3 p, uint32_t seed) {
  // Odd multipliers (Teschner et al., "Optimized Spatial Hashing", 2003) keep the axes apart before the mix.
  return mix((static_cast<uint32_t>(p.x) * 73856093u) ^ (static_cast<uint32_t>(p.y) * 19349663u) ^
             (static_cast<uint32_t>(p.z) * 83492791u) ^ mix(seed));
}

float Random::next() { return unit_interval(hash_lattice({count_++, 0, 0}, seed_)); }

uint32_t Random::below(uint32_t count) {
  return static_cast<uint32_t>((uint64_t{hash_lattice({count_++, 0, 0}, seed_)} * count) >> 32);
}

float gradient_noise(glm::vec3 p, uint32_t seed) {
  const glm::vec3 cell = glm::floor(p);
  const glm::ivec3 i(cell);
  const glm::vec3 f = p - cell;
  const glm::vec3 t(fade(f.x), fade(f.y), fade(f.z));
  float layer[2];
  for (int z = 0; z < 2; ++z) {
    float row[2];
    for (int y = 0; y < 2; ++y) {
      const float a = dot_gradient(hash_lattice(i + glm::ivec3(0, y, z), seed), f - glm::vec3(0, y, z));
      const float b = dot_gradient(hash_lattice(i + glm::ivec3(1, y, z), seed), f - glm::vec3(1, y, z));
      row[y] = a + t.x * (b - a);
    }
    layer[z] = row[0] + t.y * (row[1] - row[0]);
  }
  return layer[0] + t.z * (layer[1] - layer[0]);
}

float fractal_noise(glm::vec3 p, int octaves, uint32_t seed) {
  float sum = 0, amplitude = 1, total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * gradient_noise(p, seed + static_cast<uint32_t>(octave));
    total += amplitude;
    amplitude *= 0.5f;
    p *= 2.0f;
  }
  return sum / total;
}

CellSample cell_noise(glm::vec3 p, uint32_t seed) {
  const glm::vec3 cell = glm::floor(p);
  float nearest2 = 1e9f, second2 = 1e9f;
  uint32_t id = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const glm::vec3 corner = cell + glm::vec3(x, y, z);
        const uint32_t hash = hash_lattice(glm::ivec3(corner), seed);
        // Three ten-bit fields of the hash place the point in its cube.
        const glm::vec3 offset = glm::vec3(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u) * (1.0f / 1024.0f);
        const glm::vec3 to = corner + offset - p;
        const float d2 = glm::dot(to, to);
        if (d2 < nearest2) {
          second2 = nearest2;
          nearest2 = d2;
          id = hash;
        } else if (d2 < second2) {
          second2 = d2;
        }
      }
  return {std::sqrt(nearest2), std::sqrt(second2), unit_interval(mix(id))};
}

}  // namespace lamina
