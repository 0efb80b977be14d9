// SPDX-License-Identifier: Apache-2.0
// The smaller cap's area, faded linearly from contained to apart: exact for two hemispheres.
#include "cap.glsl"

float linear_cap(float r0, float r1, float d) { return cap_area(min(r0, r1)) * cap_overlap(r0, r1, d); }
