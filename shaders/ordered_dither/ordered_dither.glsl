// SPDX-License-Identifier: Apache-2.0
// Bayer's 4x4 threshold of a pixel by the function that ORDERED_DITHER names. x, y: whole numbers from 0.
#include "dither/dither.glsl"

float by_bits(float x, float y) { return bayer_4x4(ivec2(x, y)); }

float from_matrix(float x, float y) {
  const int ranks[16] = int[](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
  return (float(ranks[(int(y) & 3) * 4 + (int(x) & 3)]) + 0.5) / 16.0;
}

// Floats alone, as shaders without integers do: 2x2 by fract(x / 2 + 3 y^2 / 4), twice. Beyond row 2364 a float has no room for 3 y^2 / 4.
float squares_2x2(vec2 at) {
  at = floor(at);
  return fract(at.x * 0.5 + at.y * at.y * 0.75);
}
float by_squares(float x, float y) { return squares_2x2(vec2(x, y) * 0.5) * 0.25 + squares_2x2(vec2(x, y)) + 1.0 / 32.0; }

// The same with y folded first.
float by_folded_squares(float x, float y) { return by_squares(mod(x, 4.0), mod(y, 4.0)); }

float ordered_dither(float x, float y) { return ORDERED_DITHER(x, y); }
