// SPDX-License-Identifier: Apache-2.0
// The wrapped cosine by the function that WRAP_LIGHTING names.
#include "half_lambert.glsl"
#include "normalised_wrap.glsl"
#include "plain_lambert.glsl"
#include "power_wrap.glsl"
#include "printed_wrap.glsl"

float wrapped_light(float c, float w) { return WRAP_LIGHTING(c, w); }
