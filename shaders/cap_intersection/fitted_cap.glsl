// SPDX-License-Identifier: Apache-2.0
// The smaller cap's area, faded from contained to apart by a polynomial in the overlap, whose shape follows the radii's ratio and the
// smaller radius: fitted for radii up to pi / 2 by tools/fit_cap. It never grows with the distance there.
#ifndef FITTED_CAP_GLSL
#define FITTED_CAP_GLSL
#include "cap.glsl"

float fitted_cap(float r0, float r1, float d) {
  float smaller = min(r0, r1), ratio = smaller / max(r0, r1), squared = smaller * smaller;
  float s = min(squared, hemisphere_squared), rs = ratio * s;
  float t = cap_overlap(r0, r1, d);
  float bend = -0.68218 + 0.49769 * s - 0.28086 * ratio + rs * (0.07431 * rs - 0.37887) +
               t * (2.21528 - 0.08912 * s * s + t * (-2.81964 - 0.67678 * ratio * ratio + t * 2.17355));
  return cap_area_polynomial(squared) * (t + t * (1.0 - t) * bend);
}

#endif
