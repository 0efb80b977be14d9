// SPDX-License-Identifier: Apache-2.0
// Oat and Sander, "Ambient Aperture Lighting", in: Oat, "Efficient Shader Tricks That Will Impress Your Friends", GDC 2006, part 2,
// SphericalCapIntersectionAreaFast: the smaller cap's area, faded by a smoothstep from contained to apart.
#include "cap.glsl"

float smoothstep_cap(float r0, float r1, float d) {
  float t = cap_overlap(r0, r1, d);
  return cap_area(min(r0, r1)) * t * t * (3.0 - 2.0 * t);
}
