// SPDX-License-Identifier: Apache-2.0
// Ward, "Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992: exp(-tan^2) / (4 pi ax ay sqrt(nl nv)). Loses light
// towards grazing: half of it at 60 degrees.
#include "slopes.glsl"
float ward(vec3 l, vec3 v, float ax, float ay) {
  if (l.z <= 0.0 || v.z <= 0.0) return 0.0;
  return slopes(l + v, ax, ay) * sqrt(l.z / v.z) / (4.0 * ax * ay);
}
