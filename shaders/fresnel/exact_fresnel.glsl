// SPDX-License-Identifier: Apache-2.0
// Fresnel's reflectance of unpolarized light at a smooth boundary, in the form of Cook and Torrance, "A Reflectance Model for
// Computer Graphics", SIGGRAPH 1981, without cancellation: with m = n^2 - 1 and g = sqrt(c^2 + m), the differences c - g and
// n^2 c - g are products of m. c: cosine on the side that the light comes from; n: index that it goes into over the one that it
// comes from. Below 1, beyond the critical angle, all is reflected.
#ifndef EXACT_FRESNEL_GLSL
#define EXACT_FRESNEL_GLSL
#include "../common/refracted_square.glsl"

float exact_fresnel(float c, float n) {
  precise float m = (n - 1.0) * (n + 1.0), square = refracted_square(c, n);
  if (!(square > 0.0)) return m < 0.0 ? 1.0 : 0.0;
  precise float g = sqrt(square), sum = c + g, across = m / (sum * sum);
  precise float along = m * (c * sum - 1.0) / (sum * (n * n * c + g));
  return 0.5 * (across * across + along * along);
}

#endif
