// SPDX-License-Identifier: Apache-2.0
// Schlick's form, from inside with the cosine outside, which is 0 at the critical angle.
float schlick_both_sides(float c, float n) {
  float normal = (n - 1.0) / (n + 1.0), f0 = normal * normal;
  float outside = n < 1.0 ? sqrt(max(1.0 - (1.0 - c * c) / (n * n), 0.0)) : c;
  float d = 1.0 - outside, d2 = d * d;
  return f0 + (1.0 - f0) * (d2 * d2 * d);
}
