// SPDX-License-Identifier: Apache-2.0
// The formula of Oat and Sander, "Ambient Aperture Lighting" (Oat, GDC 2006, part 2), with the constant that the slide lost:
// three arc cosines of quotients that cancel. Kept to show what the cancellation costs in binary32.
#include "cap.glsl"

float naive_cap(float r0, float r1, float d) {
  if (d >= r0 + r1) return 0.0;
  if (d <= abs(r0 - r1)) return 2.0 * pi * (1.0 - cos(min(r0, r1)));
  float c0 = cos(r0), c1 = cos(r1), cd = cos(d), s0 = sin(r0), s1 = sin(r1), sd = sin(d);
  if (r0 + r1 + d >= 2.0 * pi) return -2.0 * pi * (c0 + c1);
  return 2.0 * pi - 2.0 * pi * c0 - 2.0 * pi * c1 - 2.0 * acos((cd - c0 * c1) / (s0 * s1)) +
         2.0 * c0 * acos((-c1 + cd * c0) / (sd * s0)) + 2.0 * c1 * acos((-c0 + cd * c1) / (sd * s1));
}
