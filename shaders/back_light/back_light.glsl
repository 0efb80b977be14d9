// SPDX-License-Identifier: Apache-2.0
// The lobe by the function that BACK_LIGHT names.
#include "exp2_lobe.glsl"
#include "exp_lobe.glsl"
#include "normalised_lobe.glsl"
#include "rational_lobe.glsl"
#include "raw_lobe.glsl"

float back_light(float vl, float nl, float vn, float d, float p) { return BACK_LIGHT(vl, nl, vn, d, p); }
