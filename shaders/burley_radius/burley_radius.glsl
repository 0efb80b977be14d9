// SPDX-License-Identifier: Apache-2.0
// The radius by the function that BURLEY_RADIUS names.
#include "burley_closed.glsl"
#include "burley_exponential.glsl"
#include "burley_series.glsl"

float burley_radius(float u) { return BURLEY_RADIUS(u); }
