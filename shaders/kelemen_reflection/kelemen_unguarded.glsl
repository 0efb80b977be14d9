// SPDX-License-Identifier: Apache-2.0
// As listings have it: opposite directions make a half-way vector of length 0, and a facet edge-on divides by 0.
float kelemen_unguarded(float nl, float nv, float lv, float m) {
  float squared = 2.0 + 2.0 * lv, nh = (nl + nv) / sqrt(squared), tangent = (1.0 - nh * nh) / (nh * nh);
  float fresnel = 0.028 + 0.972 * pow(1.0 - 0.5 * sqrt(squared), 5.0);
  return nl * fresnel * exp(-tangent / (m * m)) / (m * m * pow(nh, 4.0)) / squared;
}
