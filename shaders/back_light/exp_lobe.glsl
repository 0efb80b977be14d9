// SPDX-License-Identifier: Apache-2.0
// The same with the right factor: x^p by e^(p x - p), which has the value and the slope of x^p at 1 (a spherical Gaussian).
float exp_lobe(float vl, float nl, float vn, float d, float p) {
  float squared = 1.0 + d * (2.0 * nl + d);
  float base = clamp(-(vl + d * vn) * inversesqrt(max(squared, 1e-12)), 0.0, 1.0);
  return exp2((p * base - p) * 1.442695);
}
