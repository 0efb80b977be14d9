// SPDX-License-Identifier: Apache-2.0
// Codes of 24 bits in three 16-bit floats. As whole numbers, signed by side: exact while every channel stays within 2048, so for 8
// pairs. And as n / 255, which no 16-bit float holds: the naive form.
#include "codes.glsl"

vec3 toward_zero_half3(vec3 x) { return vec3(toward_zero_half(x.x), toward_zero_half(x.y), toward_zero_half(x.z)); }

vec3 sum_of_codes(float front, float back, float step, int pairs, float unit) {
  precise vec3 sum = vec3(0.0);
  for (int k = 0; k < pairs; ++k) {
    sum = toward_zero_half3(sum - toward_zero_half3(vec3(split_code(code_of(depth_of_pair(front, step, k), 8), 8)) * unit));
    sum = toward_zero_half3(sum + toward_zero_half3(vec3(split_code(code_of(depth_of_pair(back, step, k), 8), 8)) * unit));
  }
  return sum;
}

float integer_codes_sum(float front, float back, float step, int pairs) {
  vec3 sum = sum_of_codes(front, back, step, pairs, 1.0);
  return float(joined_code(ivec3(sum), 8)) / code_scale(8);
}

float unit_codes_half_sum(float front, float back, float step, int pairs) {
  vec3 sum = sum_of_codes(front, back, step, pairs, 1.0 / 255.0) * 255.0;
  return (sum.x * 65536.0 + sum.y * 256.0 + sum.z) / code_scale(8);
}
