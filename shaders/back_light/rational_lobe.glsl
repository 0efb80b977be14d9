// SPDX-License-Identifier: Apache-2.0
// Schlick, "A Fast Alternative to Phong's Specular Model", Graphics Gems IV, 1994: x^p by x / (p - p x + x).
float rational_lobe(float vl, float nl, float vn, float d, float p) {
  float squared = 1.0 + d * (2.0 * nl + d);
  float base = clamp(-(vl + d * vn) * inversesqrt(max(squared, 1e-12)), 0.0, 1.0);
  return base / (p - p * base + base);
}
