// SPDX-License-Identifier: Apache-2.0
// The power by one exponential, as Filament does: x^p by 2^(p x - p), which is its tangent only up to a factor.
float exp2_lobe(float vl, float nl, float vn, float d, float p) {
  float squared = 1.0 + d * (2.0 * nl + d);
  float base = clamp(-(vl + d * vn) * inversesqrt(max(squared, 1e-12)), 0.0, 1.0);
  return exp2(p * base - p);
}
