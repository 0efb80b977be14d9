// SPDX-License-Identifier: Apache-2.0
// The blended cosine by the function that BLENDED_NORMALS names.
#include "blended_first.glsl"
#include "blended_mended.glsl"
#include "blended_printed.glsl"

float blended_normals(float vertex, float bump, float red, float rest) { return BLENDED_NORMALS(vertex, bump, red, rest); }
