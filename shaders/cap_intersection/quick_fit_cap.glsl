// SPDX-License-Identifier: Apache-2.0
// Between linear and smoothstep, as fitted_cap, by four coefficients. Found by tools/fit_cap.
#include "cap.glsl"

float quick_fit_cap(float r0, float r1, float d) {
  float smaller = min(r0, r1), ratio = smaller / max(r0, r1), squared = smaller * smaller;
  float s = min(squared, hemisphere_squared);
  float t = cap_overlap(r0, r1, d);
  float bend = -0.63127 + 0.18956 * s + t * (1.17247 - 0.84536 * ratio * ratio);
  return cap_area_polynomial(squared) * (t + t * (1.0 - t) * bend);
}
