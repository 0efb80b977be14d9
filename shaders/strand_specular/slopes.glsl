// SPDX-License-Identifier: Apache-2.0
#ifndef SLOPES_GLSL
#define SLOPES_GLSL
// exp(-tan^2) of the half-way vector h, which need not be unit: microfacets of that slope.
float slopes(vec3 h, float ax, float ay) {
  vec2 slope = h.xy / vec2(ax, ay);
  return exp(-dot(slope, slope) / max(h.z * h.z, 1e-12));
}
#endif
