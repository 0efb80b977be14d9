// SPDX-License-Identifier: Apache-2.0
// The quotients as textbooks print them, by Snell's law for the cosine on the far side: they cancel where n is near 1.
float textbook_fresnel(float c, float n) {
  float sine = sqrt(max(1.0 - c * c, 0.0)) / n;
  if (sine >= 1.0) return 1.0;
  float t = sqrt(1.0 - sine * sine);
  float across = (c - n * t) / (c + n * t), along = (n * c - t) / (n * c + t);
  return 0.5 * (across * across + along * along);
}
