// SPDX-License-Identifier: Apache-2.0
// Jimenez' interleaved gradient noise by the function that GRADIENT_NOISE names. x, y: whole numbers from 0. The noise jumps
// from 1 to 0; errors are those of a place on the circle.
#include "dither/dither.glsl"

float single_product(float x, float y) { return gradient_noise(vec2(x, y)); }

// Factors in two parts: the first has 12 bits, so that its product is exact up to 2^12 pixels, and loses its whole number before
// anything is rounded.
float two_parts(float x, float y) {
  precise float wide = fract(x * 0.067138671875) + fract(y * 0.00583648681640625);
  precise float rest = x * -2.8111875e-5 + y * 6.6318359375e-7;
  return fract(52.9829189 * fract(fract(wide) + rest));
}

// By the half-precision sum of the products, as where a compiler was told that this is enough.
float half_sum(float x, float y) {
  float sum = unpackHalf2x16(packHalf2x16(vec2(dot(vec2(x, y), vec2(0.06711056, 0.00583715)), 0.0))).x;
  return fract(52.9829189 * fract(sum));
}

float noise_of_pixel(float x, float y) { return GRADIENT_NOISE(x, y); }
