// SPDX-License-Identifier: Apache-2.0
// Repeatable randomness for scenes made by code: an integer hash, a generator on it, and noise over space. The same inputs give
// the same numbers on every machine, which no distribution of the standard library promises.
// Sources: Appleby, MurmurHash3, 2011 (the finalizer); Perlin, "Improving Noise", SIGGRAPH 2002; Worley, "A Cellular Texture
// Basis Function", SIGGRAPH 1996. Limits: coordinates within +-2^30.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace lamina {

// 32 well-mixed bits of a lattice point.
uint32_t hash_lattice(glm::ivec3 p, uint32_t seed);

// Uniform numbers one after another; the n-th depends on the seed and n alone.
class Random {
 public:
  explicit Random(uint32_t seed) : seed_(seed) {}
  // In [0, 1).
  float next();
  // In [0, count); count > 0.
  uint32_t below(uint32_t count);

 private:
  uint32_t seed_;
  int count_ = 0;
};

// Perlin's gradient noise: within [-1, 1], 0 at lattice points, one bump a unit.
float gradient_noise(glm::vec3 p, uint32_t seed);

// Sum of `octaves` (>= 1) noises, each of twice the frequency and half the amplitude of the one before, over the sum of
// amplitudes.
float fractal_noise(glm::vec3 p, int octaves, uint32_t seed);

// Worley's cells: one random point in each unit cube.
struct CellSample {
  float nearest = 0, second = 0;  // distances to the two nearest points, nearest <= second
  float shade = 0;                // a number in [0, 1) of the nearest point's own
};
CellSample cell_noise(glm::vec3 p, uint32_t seed);

}  // namespace lamina
