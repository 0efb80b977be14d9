// SPDX-License-Identifier: Apache-2.0
// As fitted_cap, with a square root, since the area behaves as a power of 3/2 at both ends, and more coefficients. Found by
// tools/fit_cap.
#include "cap.glsl"

float close_fit_cap(float r0, float r1, float d) {
  float smaller = min(r0, r1), ratio = smaller / max(r0, r1), squared = smaller * smaller;
  float s = min(squared, hemisphere_squared), rs = ratio * s, cube = ratio * ratio * ratio;
  float t = cap_overlap(r0, r1, d), product = t * (1.0 - t), w = sqrt(product);
  float bend = -1.02679 + 0.96042 * s + rs * (0.188 * rs - 1.11486) +
               t * (2.04805 - 0.40565 * s + 0.59615 * ratio * rs - cube * (1.06337 + 0.15244 * s * s)) +
               w * (1.05745 - 0.84246 * ratio + cube * (0.66242 + s * (0.35093 - 0.17174 * s)) + t * (0.64941 * cube - 2.04492));
  return cap_area_polynomial(squared) * max(t + product * bend, 0.0);
}
