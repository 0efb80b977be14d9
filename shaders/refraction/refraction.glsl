// SPDX-License-Identifier: Apache-2.0
// The reflectance by the function that REFRACTION names.
#include "angle_fresnel.glsl"
#include "exact_fresnel.glsl"
#include "schlick.glsl"
#include "schlick_both_sides.glsl"
#include "textbook_fresnel.glsl"

float reflectance(float c, float n) { return REFRACTION(c, n); }
