// SPDX-License-Identifier: Apache-2.0
// The distance, in units of d, within which the share u of light leaves by Burley's profile (P. Christensen and B. Burley,
// "Approximate Reflectance Profiles for Efficient Subsurface Scattering", 2015): 1 - u = (x^3 + 3x) / 4 with x = exp(-r / 3d)
// is a cubic with one root. Near 0 the root's logarithm loses its digits: a series takes over.
#ifndef BURLEY_SERIES_GLSL
#define BURLEY_SERIES_GLSL
float burley_series(float u) {
  float w = 2.0 * (1.0 - u), g = pow(w + sqrt(w * w + 1.0), 1.0 / 3.0);
  // g - 1 / g without cancellation where both are near 1: u near 1.
  float x = w < 0.1 ? 2.0 / 3.0 * w * (1.0 - w * w * (4.0 / 27.0)) : g - 1.0 / g;
  return u < 0.03 ? u * (2.0 + u * (4.0 / 3.0 + u * (32.0 / 27.0 + u * (92.0 / 81.0)))) : -3.0 * log(max(x, 1e-30));
}
#endif
