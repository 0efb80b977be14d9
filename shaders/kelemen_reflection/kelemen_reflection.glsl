// SPDX-License-Identifier: Apache-2.0
// The reflection by the function that KELEMEN_REFLECTION names.
#include "cook_torrance_reflection.glsl"
#include "kelemen_by_cosines.glsl"
#include "kelemen_unguarded.glsl"

float kelemen_reflection(float nl, float nv, float lv, float m) { return KELEMEN_REFLECTION(nl, nv, lv, m); }
