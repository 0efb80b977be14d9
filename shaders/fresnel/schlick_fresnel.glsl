// SPDX-License-Identifier: Apache-2.0
// Schlick, "An Inexpensive BRDF Model for Physically-Based Rendering", Eurographics 1994, of the cosine given: made for
// light from outside. Knows no critical angle.
float schlick_fresnel(float c, float n) {
  float normal = (n - 1.0) / (n + 1.0), f0 = normal * normal, d = 1.0 - c, d2 = d * d;
  return f0 + (1.0 - f0) * (d2 * d2 * d);
}
