// SPDX-License-Identifier: Apache-2.0
// Thresholds for killing pixels: in (0, 1), spread evenly.

// Bayer, "An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures", 1973: the 4x4 matrix by its bits, in the
// middles of sixteenths. An opacity of k/16 keeps k pixels of each 16.
float bayer_4x4(ivec2 pixel) {
  int x = pixel.x & 3, y = pixel.y & 3, d = x ^ y;
  int rank = ((d & 1) << 3) | ((y & 1) << 2) | (d & 2) | ((y & 2) >> 1);
  return (float(rank) + 0.5) / 16.0;
}

// The same ranks in another order for each card: rank * odd + shift, modulo 16. So each card keeps its share of each 16, and two
// cards' thresholds in a 4x4 block are a lattice of rank 1 (Korobov 1959): they hide as many of each other's pixels as if by
// chance. `within`: where in its sixteenth the threshold lies, 0 to 1.
float lattice_4x4(ivec2 pixel, uint card, float within) {
  uint rank = uint(bayer_4x4(pixel) * 16.0), chosen = card * 2654435761u;
  uint moved = (rank * ((chosen >> 26u) * 2u + 1u) + (chosen >> 20u)) & 15u;
  return (float(moved) + clamp(within, 1e-4, 1.0 - 1e-4)) / 16.0;
}

// Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014: interleaved gradient noise.
float gradient_noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

// After pcg3d (Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020): its first output, with the first of its two
// rounds on all three words at once.
float white_noise(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v += v.yzx * v.zxy;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return (float(v.x >> 8u) + 0.5) / 16777216.0;
}

// Wyman and McGuire, "Hashed Alpha Testing", I3D 2017: noise over the object's own space at the two powers of two around a
// pixel's size, mixed, and made even again by the mix's distribution. `pixel_m`: how far the place moves from pixel to pixel.
float hash_of_cell(vec3 cell) { return white_noise(uvec3(ivec3(cell) + 0x40000000)); }
float hashed_threshold(vec3 place, float pixel_m) {
  float level = log2(1.0 / max(pixel_m, 1e-8)), between = fract(level);
  float scale = exp2(floor(level));
  float mixed = mix(hash_of_cell(floor(place * scale)), hash_of_cell(floor(place * (2.0 * scale))), between);
  float a = min(between, 1.0 - between);
  if (a < 1e-4) return clamp(mixed, 1e-6, 1.0 - 1e-6);
  float low = mixed * mixed / (2.0 * a * (1.0 - a)), middle = (mixed - 0.5 * a) / (1.0 - a),
        high = 1.0 - (1.0 - mixed) * (1.0 - mixed) / (2.0 * a * (1.0 - a));
  return clamp(mixed < a ? low : mixed < 1.0 - a ? middle : high, 1e-6, 1.0 - 1e-6);
}
