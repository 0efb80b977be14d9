// SPDX-License-Identifier: Apache-2.0
// A lobe around the way of the light, bent by the normal: the base is the cosine between V and the unit vector along -(L + d N).
// vl, nl, vn: cosines between view, light and normal; d: bend; p: power.
#ifndef NORMALISED_LOBE_GLSL
#define NORMALISED_LOBE_GLSL
float normalised_lobe(float vl, float nl, float vn, float d, float p) {
  float squared = 1.0 + d * (2.0 * nl + d);
  float base = -(vl + d * vn) * inversesqrt(max(squared, 1e-12));
  return base > 0.0 ? pow(min(base, 1.0), p) : 0.0;
}
#endif
