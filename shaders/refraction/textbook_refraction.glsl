// SPDX-License-Identifier: Apache-2.0
// As textbooks print it: 1 less the square of the refracted sine, which cancels near the critical angle.
float textbook_refraction(float c, float n) { return sqrt(max(1.0 - (1.0 - c * c) / (n * n), 0.0)); }
