// SPDX-License-Identifier: Apache-2.0
#ifndef RANDOM_GLSL
#define RANDOM_GLSL

// A random number from 0 to 1 for three words: O'Neill, "PCG", 2014, as a hash (Jarzynski and Olano, "Hash Functions for GPU
// Rendering", JCGT 9(3), 2020).
float random_of(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  return float(v.x >> 8u) / 16777216.0;
}

#endif
