// SPDX-License-Identifier: Apache-2.0
// One Gaussian, the best for an edge of light.
float one_gaussian_sum(float r) { return exp(-0.5 * r * r / 0.374544) / (6.2831853 * 0.374544); }
