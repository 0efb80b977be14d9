// SPDX-License-Identifier: Apache-2.0
// Cook and Torrance's, of which Kelemen and Szirmay-Kalos' leaves out the masking term.
#include "../beckmann/beckmann_without_angles.glsl"
float cook_torrance_reflection(float nl, float nv, float lv, float m) {
  float squared = max(2.0 + 2.0 * lv, 1e-7), length_h = sqrt(squared), hv = 0.5 * length_h, nh = (nl + nv) / length_h;
  float base = 1.0 - hv, twice = base * base, fresnel = 0.028 + 0.972 * twice * twice * base;
  float masked = min(1.0, 2.0 * nh * min(max(nl, 0.0), nv) / hv);
  return fresnel * masked * beckmann_without_angles(nh, m) / (4.0 * max(nv, 1e-4));
}
