// SPDX-License-Identifier: Apache-2.0
// One running sum of 32-bit floats, signed by side: what blending into r32_float does.

float float_sum32(float front, float back, float step, int pairs) {
  precise float sum = 0.0;
  for (int k = 0; k < pairs; ++k) {
    sum -= depth_of_pair(front, step, k);
    sum += depth_of_pair(back, step, k);
  }
  return sum;
}
