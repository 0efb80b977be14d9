// SPDX-License-Identifier: Apache-2.0
// The cosine on the far side of a smooth boundary, 0 beyond the critical angle: see refracted_square.glsl.
#include "../common/refracted_square.glsl"

float exact_refraction(float c, float n) { return sqrt(max(refracted_square(c, n), 0.0)) / n; }
