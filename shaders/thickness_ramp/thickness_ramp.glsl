// SPDX-License-Identifier: Apache-2.0
// What passes an optical depth, by the function that THICKNESS_RAMP names.
#include "exponential.glsl"
#include "ramp_half.glsl"
#include "ramp_squared.glsl"
#include "ramp_srgb8.glsl"
#include "ramp_unorm8.glsl"

float passed_light(float x) { return THICKNESS_RAMP(x); }
