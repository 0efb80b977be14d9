// SPDX-License-Identifier: Apache-2.0
// See noise.h.
#include "harness/scene/made/noise.h"

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

// Odd multipliers keep the axes apart before the mix (Teschner et al., "Optimized Spatial Hashing", 2003).
constexpr uint32_t axis_x = 73856093u, axis_y = 19349663u, axis_z = 83492791u;

// Perlin's twelve directions to the edges of a cube, four of them twice to make sixteen.
float dot_gradient(uint32_t hash, float x, float y, float z) {
  static constexpr float directions[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                              {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                              {1, 1, 0},  {-1, 1, 0},  {0, -1, 1}, {0, -1, -1}};
  const float* g = directions[hash >> 28];
  return x * g[0] + y * g[1] + z * g[2];
}

// std::floor is a call into the library on machines without SSE 4.1; noise is where a texture's time goes.
int floor_int(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i) ? 1 : 0);
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

uint32_t hash_lattice(glm::ivec3 p, uint32_t seed) {
  return mix((static_cast<uint32_t>(p.x) * axis_x) ^ (static_cast<uint32_t>(p.y) * axis_y) ^
             (static_cast<uint32_t>(p.z) * axis_z) ^ mix(seed));
}

float Random::next() { return unit_interval(hash_lattice({count_++, 0, 0}, seed_)); }

uint32_t Random::below(uint32_t count) {
  return static_cast<uint32_t>((uint64_t{hash_lattice({count_++, 0, 0}, seed_)} * count) >> 32);
}

float gradient_noise(glm::vec3 p, uint32_t seed) {
  const int ix = floor_int(p.x), iy = floor_int(p.y), iz = floor_int(p.z);
  const float fx = p.x - static_cast<float>(ix), fy = p.y - static_cast<float>(iy), fz = p.z - static_cast<float>(iz);
  const float tx = fade(fx), ty = fade(fy), tz = fade(fz);
  // hash_lattice() of the eight corners, with what they share computed once.
  const uint32_t hx[2] = {static_cast<uint32_t>(ix) * axis_x, static_cast<uint32_t>(ix) * axis_x + axis_x};
  const uint32_t hy[2] = {static_cast<uint32_t>(iy) * axis_y, static_cast<uint32_t>(iy) * axis_y + axis_y};
  const uint32_t hz[2] = {static_cast<uint32_t>(iz) * axis_z, static_cast<uint32_t>(iz) * axis_z + axis_z};
  const uint32_t hs = mix(seed);
  float layer[2];
  for (int z = 0; z < 2; ++z) {
    float row[2];
    for (int y = 0; y < 2; ++y) {
      const uint32_t rest = hy[y] ^ hz[z] ^ hs;
      const float gy = fy - static_cast<float>(y), gz = fz - static_cast<float>(z);
      const float a = dot_gradient(mix(hx[0] ^ rest), fx, gy, gz), b = dot_gradient(mix(hx[1] ^ rest), fx - 1, gy, gz);
      row[y] = a + tx * (b - a);
    }
    layer[z] = row[0] + ty * (row[1] - row[0]);
  }
  return layer[0] + tz * (layer[1] - layer[0]);
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
  const glm::vec3 cell(floor_int(p.x), floor_int(p.y), floor_int(p.z));
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
