// SPDX-License-Identifier: Apache-2.0
// The refracted cosine by the function that REFRACTION names.
#include "angle_refraction.glsl"
#include "builtin_refraction.glsl"
#include "exact_refraction.glsl"
#include "textbook_refraction.glsl"

float refracted_cosine(float c, float n) { return REFRACTION(c, n); }
