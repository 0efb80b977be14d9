// SPDX-License-Identifier: Apache-2.0
// As Barre-Brisebois and Bouchard print it (GDC 2011): L + d N is not a unit vector.
#ifndef RAW_LOBE_GLSL
#define RAW_LOBE_GLSL
float raw_lobe(float vl, float nl, float vn, float d, float p) {
  float base = clamp(-(vl + d * vn), 0.0, 1.0);
  return base > 0.0 ? pow(base, p) : 0.0;
}
#endif
