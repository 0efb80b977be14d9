// SPDX-License-Identifier: Apache-2.0
// Beckmann's distribution by the function that BECKMANN names.
#include "beckmann_by_angles.glsl"
#include "beckmann_tables.glsl"
#include "beckmann_without_angles.glsl"

float beckmann(float nh, float m) { return BECKMANN(nh, m); }
