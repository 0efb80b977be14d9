// SPDX-License-Identifier: Apache-2.0
// Between linear and smoothstep: a fade whose shape follows the radii's ratio and size, fitted for radii up to pi / 2.
#include "cap.glsl"

float fitted_cap(float r0, float r1, float d) {
  float larger = max(r0, r1);
  float ratio = min(r0, r1) / larger;
  float squared = ratio * ratio;
  float u = pow(cap_overlap(r0, r1, d), 1.0 + 0.4 * squared * cos(larger));
  float weight = 0.5 - 0.1 * ratio - 0.4 * squared * squared;
  return cap_area(min(r0, r1)) * (u + weight * (u * u * (3.0 - 2.0 * u) - u));
}
