// SPDX-License-Identifier: Apache-2.0
// Less what the slope can make of half a texel: lit sides get 0 for certain, and thin ones let too much through.
float slope_bias(float s, float slope, float u) { return max(s + slope * u - 0.5 * slope, 0.0); }
