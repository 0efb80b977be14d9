// SPDX-License-Identifier: Apache-2.0
// Less a texel.
float constant_bias(float s, float slope, float u) { return max(s + slope * u - 1.0, 0.0); }
