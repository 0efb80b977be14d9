// SPDX-License-Identifier: Apache-2.0
// Fresnel's reflectance of unpolarized light at a smooth boundary, without cancellation: with m = n^2 - 1 and g = sqrt(c^2 + m), the
// differences c - g and n^2 c - g are products of m. c: cosine on the side that the light comes from; n: index that it goes into
// over the one that it comes from. Below 1, beyond the critical angle, all is reflected.
#ifndef EXACT_FRESNEL_GLSL
#define EXACT_FRESNEL_GLSL

float exact_fresnel(float c, float n) {
  precise float m = (n - 1.0) * (n + 1.0), sine = sqrt((1.0 - c) * (1.0 + c));
  // The same number twice: near the critical angle each loses what the other keeps.
  precise float k = c < 0.7 ? c * c + m : (n - sine) * (n + sine);
  if (!(k > 0.0)) return m < 0.0 ? 1.0 : 0.0;
  precise float g = sqrt(k), sum = c + g, across = m / (sum * sum);
  precise float along = m * (c * sum - 1.0) / (sum * (n * n * c + g));
  return 0.5 * (across * across + along * along);
}

#endif
