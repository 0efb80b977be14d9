// SPDX-License-Identifier: Apache-2.0
// The first reflection (R) of Karis, "Physically Based Hair Shading in Unreal", SIGGRAPH 2016 course, without Fresnel's factor,
// by the function that KARIS_REFLECTION names. c: cosine of half the azimuth, 0 where light and eye are opposite; sl, sv: sines
// of the inclinations of light and eye; b: the lobe's width, roughness squared. Scales are tilted by 0.07 radians.

const float sin_tilt = -0.0699428473, cos_tilt = 0.997551000;  // of -2 * 0.035

float from_peak(float c, float sl, float sv) {
  float cv = sqrt(max((1.0 - sv) * (1.0 + sv), 0.0));
  return sl + sv - 2.0 * sin_tilt * (cos_tilt * c * cv + sin_tilt * sv);
}

// As printed: a Gaussian of width sqrt(2) b c, times c / 4. 0 / 0 where c is 0.
float plain_lobe(float c, float sl, float sv, float b) {
  float width = 1.41421356 * b * c, x = from_peak(c, sl, sv) / width;
  return exp(-0.5 * x * x) / (2.50662827 * width) * 0.25 * c;
}
// The width kept above 1e-3.
float clamped_width(float c, float sl, float sv, float b) {
  float width = max(1.41421356 * b * c, 1e-3), x = from_peak(c, sl, sv) / width;
  return exp(-0.5 * x * x) / (2.50662827 * width) * 0.25 * c;
}
// c multiplied through: the peak is 1 / (8 sqrt(pi) b) whatever c.
float multiplied_through(float c, float sl, float sv, float b) {
  float x = from_peak(c, sl, sv) / max(1.41421356 * b * c, 1e-18);
  return exp(-0.5 * min(x * x, 1e4)) * 0.0705236979 / b;
}

float karis_reflection(float c, float sl, float sv, float b) { return KARIS_REFLECTION(c, sl, sv, b); }
