// SPDX-License-Identifier: Apache-2.0
// Beckmann's distribution without 1/pi, by cosines alone: tan^2 = (1 - x)(1 + x) / x^2 keeps its digits at x = 1.
#ifndef BECKMANN_WITHOUT_ANGLES_GLSL
#define BECKMANN_WITHOUT_ANGLES_GLSL
float beckmann_without_angles(float nh, float m) {
  float x = clamp(nh, 0.0, 1.0), squared = max(x * x, 1e-7), rough = m * m;
  return exp(-max((1.0 - x) * (1.0 + x), 0.0) / (squared * rough)) / (rough * squared * squared);
}
#endif
