// SPDX-License-Identifier: Apache-2.0
// Running sums of 16-bit floats, rounded toward zero as llvmpipe's render targets do. Other devices round to nearest.

float toward_zero_half(float x) {
  if (abs(x) < 6.103515625e-5) return trunc(x * 16777216.0) / 16777216.0;  // below 2^-14 steps are of 2^-24
  return uintBitsToFloat(floatBitsToUint(x) & 0xffffe000u);
}

float half_sum16(float front, float back, float step, int pairs) {
  precise float sum = 0.0;
  for (int k = 0; k < pairs; ++k) {
    sum = toward_zero_half(sum - toward_zero_half(depth_of_pair(front, step, k)));
    sum = toward_zero_half(sum + toward_zero_half(depth_of_pair(back, step, k)));
  }
  return sum;
}
