// SPDX-License-Identifier: Apache-2.0
// The quotients as textbooks print them, by Snell's law for the cosine on the far side: they cancel where n is near 1, and are not
// a number beyond the critical angle.
float textbook_fresnel(float c, float n) {
  float sine = sqrt(1.0 - c * c) / n, t = sqrt(1.0 - sine * sine);
  float across = (c - n * t) / (c + n * t), along = (n * c - t) / (n * c + t);
  return 0.5 * (across * across + along * along);
}
