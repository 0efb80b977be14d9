// SPDX-License-Identifier: Apache-2.0
// Valve's half Lambert, squared: one curve for any w, and 4/3 of the energy.
float half_lambert(float c, float w) {
  float half_cosine = 0.5 * c + 0.5;
  return half_cosine * half_cosine;
}
