// SPDX-License-Identifier: Apache-2.0
// Two Gaussians, the best for an edge of light.
float two_gaussian_sum(float r) {
  return 0.4 * exp(-0.5 * r * r / 0.0186) / (6.2831853 * 0.0186) + 0.6 * exp(-0.5 * r * r / 1.607) / (6.2831853 * 1.607);
}
