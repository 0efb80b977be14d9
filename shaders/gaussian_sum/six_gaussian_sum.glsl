// SPDX-License-Identifier: Apache-2.0
// The red of d'Eon and Luebke's profile of skin (GPU Gems 3, chapter 14) at a distance in mm, in mm^-2: w exp(-r^2 / 2v) / (2 pi v).
float six_gaussian_sum(float r) {
  const float variances[6] = float[6](0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41),
              weights[6] = float[6](0.233, 0.100, 0.118, 0.113, 0.358, 0.078);
  float sum = 0.0;
  for (int i = 0; i < 6; ++i) sum += weights[i] * exp(-0.5 * r * r / variances[i]) / (6.2831853 * variances[i]);
  return sum;
}
