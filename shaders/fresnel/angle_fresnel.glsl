// SPDX-License-Identifier: Apache-2.0
// Fresnel's own sines and tangents of sums and differences of angles, which pass through arc cosines and arc sines.
float angle_fresnel(float c, float n) {
  float sine = sqrt(max(1.0 - c * c, 0.0)) / n;
  if (sine >= 1.0) return 1.0;
  float i = acos(c), t = asin(sine);
  if (i + t < 1e-3) {  // 0 / 0
    float normal = (n - 1.0) / (n + 1.0);
    return normal * normal;
  }
  float across = sin(i - t) / sin(i + t), along = tan(i - t) / tan(i + t);
  return 0.5 * (across * across + along * along);
}
