// SPDX-License-Identifier: Apache-2.0
// Snell's law without cancellation. c: cosine on the side that the light comes from; n: index that it goes into over the one that
// it comes from. n^2 - 1 + c^2 is the square of n times the cosine on the far side; 0 or less beyond the critical angle.
#ifndef REFRACTED_SQUARE_GLSL
#define REFRACTED_SQUARE_GLSL

float refracted_square(float c, float n) {
  precise float m = (n - 1.0) * (n + 1.0), sine = sqrt((1.0 - c) * (1.0 + c));
  // The same number twice: near the critical angle each loses what the other keeps.
  precise float square = c < 0.7 ? c * c + m : (n - sine) * (n + sine);
  return square;
}

#endif
