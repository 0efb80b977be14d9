// SPDX-License-Identifier: Apache-2.0
// The path by the function that DEPTH_BIAS names.
#include "constant_bias.glsl"
#include "no_bias.glsl"
#include "plane.glsl"
#include "shrunk.glsl"
#include "slope_bias.glsl"

float biased_path(float s, float slope, float u) { return DEPTH_BIAS(s, slope, u); }
