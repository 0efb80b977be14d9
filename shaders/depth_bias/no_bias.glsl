// SPDX-License-Identifier: Apache-2.0
// The texel's own depth: lit slopes get paths of up to half a texel times the slope.
float no_bias(float s, float slope, float u) { return max(s + slope * u, 0.0); }
