// SPDX-License-Identifier: Apache-2.0
// The reflectance by the function that FRESNEL names.
#include "angle_fresnel.glsl"
#include "exact_fresnel.glsl"
#include "schlick_both_sides.glsl"
#include "schlick_fresnel.glsl"
#include "textbook_fresnel.glsl"

float reflectance(float c, float n) { return FRESNEL(c, n); }
