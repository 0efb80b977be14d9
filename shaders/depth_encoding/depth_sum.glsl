// SPDX-License-Identifier: Apache-2.0
// Thickness by sums of encoded depths: each of `pairs` pairs of faces is encoded, summed as a render target sums it, and decoded.
// Depths are shares of the greatest one, 0 to 1. Pair k lies k steps behind the first. DEPTH_SUM names the function.

// The depth of a face of pair k. `precise`: it is part of the function's definition.
float depth_of_pair(float depth, float step, int k) {
  precise float moved = step * float(k);
  precise float sum = depth + moved;
  return clamp(sum, 0.0, 1.0);
}

#include "codes_sum.glsl"
#include "depth_buffer_sum.glsl"
#include "float_sum32.glsl"
#include "half_sum16.glsl"
#include "integer_codes_sum.glsl"

// `pairs` is a whole number from 1 to 64.
float depth_sum(float front, float back, float step, float pairs) {
  return DEPTH_SUM(front, back, step, clamp(int(pairs), 1, 64));
}
