// SPDX-License-Identifier: Apache-2.0
// Seven taps of a Gaussian, whose weights are its integrals over bins a standard deviation wide (d'Eon and Luebke, GPU Gems 3,
// chapter 14). Bins widen it to a variance of 1.08, and a filter between two texels widens it again; `tap_spacing` takes both
// back.
#ifndef GAUSSIAN_TAPS_GLSL
#define GAUSSIAN_TAPS_GLSL

const float tap_weights[3] = float[3](0.242, 0.061, 0.006);  // of the taps beside the middle one; all seven sum to 1

// What linear filtering makes of a tap's squared distance: x^2 + f (1 - f).
float filtered_square(float x) { return x * x + fract(x) * (1.0 - fract(x)); }
float filtered_variance(float spacing) {
  return 2.0 * (tap_weights[0] * filtered_square(spacing) + tap_weights[1] * filtered_square(2.0 * spacing) +
                tap_weights[2] * filtered_square(3.0 * spacing));
}

// Texels between taps, for a variance in texels^2. Below a third of a texel the variance grows as the spacing does, by 0.764.
float tap_spacing(float variance) {
  if (variance < 0.2546) return variance / 0.764;
  float spacing = sqrt((variance - 0.06) / 1.08);
  for (int i = 0; i < 3; ++i) spacing *= sqrt(variance / filtered_variance(spacing));
  return spacing;
}

#endif
