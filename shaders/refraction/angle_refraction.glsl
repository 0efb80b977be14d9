// SPDX-License-Identifier: Apache-2.0
// By the angles themselves: Snell's law through an arc cosine and an arc sine.
float angle_refraction(float c, float n) {
  float sine = sin(acos(c)) / n;
  return sine >= 1.0 ? 0.0 : cos(asin(sine));
}
