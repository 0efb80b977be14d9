// SPDX-License-Identifier: Apache-2.0
float naive_hypotenuse(float a, float b) { return sqrt(a * a + b * b); }

float longer_leg(float a, float b) { return max(a, b); }

float scaled_hypotenuse(float a, float b) {
  float longer = max(a, b), ratio = min(a, b) / longer;
  return longer * sqrt(1.0 + ratio * ratio);
}

float hypotenuse(float a, float b) { return HYPOTENUSE(a, b); }
