// SPDX-License-Identifier: Apache-2.0
// The naive form: depths read back from a 32-bit float depth buffer, whose near plane is a ten-thousandth of the far one.

float from_depth_buffer(float depth) {
  const float near = 1e-4;
  precise float stored = (max(depth, near) - near) / (max(depth, near) * (1.0 - near));
  return near / (1.0 - stored * (1.0 - near));
}

float depth_buffer_sum(float front, float back, float step, int pairs) {
  precise float sum = 0.0;
  for (int k = 0; k < pairs; ++k) {
    sum -= from_depth_buffer(depth_of_pair(front, step, k));
    sum += from_depth_buffer(depth_of_pair(back, step, k));
  }
  return sum;
}
