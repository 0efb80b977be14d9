// SPDX-License-Identifier: Apache-2.0
// The sharpened shadow by the function that SHADOW_POWERS names.
#include "powers_by_logarithm.glsl"
#include "powers_printed.glsl"
#include "powers_saturated.glsl"

float shadow_powers(float s, float px, float py, float amount) { return SHADOW_POWERS(s, px, py, amount); }
