// SPDX-License-Identifier: Apache-2.0
// Codes of 12 to 21 bits in three channels of 8 bits, both sides summed apart: channels stop at 255, as blending into rgba8_unorm
// does. Exact for floor(255 / (2^L - 1)) faces a side, 17, 8, 4 and 2 for L = 4 to 7; dithered for floor(255 / 2^L), 15, 7, 3, 1.
#include "codes.glsl"

int plain_codes(float depth, float step, int pairs, int bits) {
  uvec3 sums = uvec3(0u);
  for (int k = 0; k < pairs; ++k) sums = min(sums + split_code(code_of(depth_of_pair(depth, step, k), bits), bits), 255u);
  return joined_code(ivec3(sums), bits);
}
float rgb8_sum(float front, float back, float step, int pairs, int bits) {
  return float(plain_codes(back, step, pairs, bits) - plain_codes(front, step, pairs, bits)) / code_scale(bits);
}

int dithered_codes(float depth, float step, int pairs, int bits) {
  uvec4 sums = uvec4(0u);
  for (int k = 0; k < pairs; ++k) {
    float at = depth_of_pair(depth, step, k);
    sums = min(sums + dithered_code(at, random_of(uvec3(k, floatBitsToUint(at), pairs)), bits), 255u);
  }
  return joined_dithered_code(ivec4(sums), bits);
}
float rgb8_dithered_sum(float front, float back, float step, int pairs, int bits) {
  return float(dithered_codes(back, step, pairs, bits) - dithered_codes(front, step, pairs, bits)) / code_scale(bits);
}

float rgb8_12_sum(float front, float back, float step, int pairs) { return rgb8_sum(front, back, step, pairs, 4); }
float rgb8_15_sum(float front, float back, float step, int pairs) { return rgb8_sum(front, back, step, pairs, 5); }
float rgb8_18_sum(float front, float back, float step, int pairs) { return rgb8_sum(front, back, step, pairs, 6); }
float rgb8_21_sum(float front, float back, float step, int pairs) { return rgb8_sum(front, back, step, pairs, 7); }
float rgb8_12_dithered_sum(float front, float back, float step, int pairs) {
  return rgb8_dithered_sum(front, back, step, pairs, 4);
}
float rgb8_15_dithered_sum(float front, float back, float step, int pairs) {
  return rgb8_dithered_sum(front, back, step, pairs, 5);
}
float rgb8_18_dithered_sum(float front, float back, float step, int pairs) {
  return rgb8_dithered_sum(front, back, step, pairs, 6);
}
float rgb8_21_dithered_sum(float front, float back, float step, int pairs) {
  return rgb8_dithered_sum(front, back, step, pairs, 7);
}
