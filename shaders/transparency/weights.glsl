// SPDX-License-Identifier: Apache-2.0
// Weights of blended order-independent transparency, by opacity and depth: McGuire and Bavoil, "Weighted Blended
// Order-Independent Transparency", JCGT 2(2), 2013, equations 7 to 10. A fragment adds (color alpha w, alpha w), and w has a
// factor alpha of its own. `z`: metres of view depth; `window`: depth in the depth buffer, 0 to 1.

const float least_weight = 1e-2, greatest_weight = 3e3;

float clamped_weight(float alpha, float by_depth) { return alpha * clamp(by_depth, least_weight, greatest_weight); }

float weight_equation_7(float alpha, float z, float window) {
  float near = z / 5.0, far = z / 200.0;
  return clamped_weight(alpha, 10.0 / (1e-5 + near * near + far * far * far * far * far * far));
}
float weight_equation_8(float alpha, float z, float window) {
  float near = z / 10.0, far = z / 200.0;
  return clamped_weight(alpha, 10.0 / (1e-5 + near * near * near + far * far * far * far * far * far));
}
float weight_equation_9(float alpha, float z, float window) {
  float far = z / 200.0;
  return clamped_weight(alpha, 0.03 / (1e-5 + far * far * far * far));
}
float weight_equation_10(float alpha, float z, float window) {
  float in_front = 1.0 - window;
  return alpha * max(least_weight, greatest_weight * in_front * in_front * in_front);
}

// What many programs have copied from one another. It is at its upper bound for every alpha above about 0.03, at any depth, and
// so a plain average weighted by alpha.
float weight_saturated(float alpha, float z, float window) {
  float by_alpha = min(1.0, 10.0 * alpha) + 0.01, in_front = 1.0 - 0.9 * window;
  return clamp(by_alpha * by_alpha * by_alpha * 1e8 * in_front * in_front * in_front, least_weight, greatest_weight);
}

// No depth at all: the average of colours, weighted by alpha.
float weight_average(float alpha, float z, float window) { return 1.0; }
