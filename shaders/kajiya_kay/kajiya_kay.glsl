// SPDX-License-Identifier: Apache-2.0
// The lobe of Kajiya and Kay's cone by the function that KAJIYA_KAY names. tl, tv: cosines between the strand and directions to
// the light and the eye; lv: between these two; p: power.
#include "strand_specular/kajiya_kay.glsl"

// cone_cosine() to the power, as the effect has it.
float guarded_cone(float tl, float tv, float lv, float p) {
  float cone = cone_cosine(tl, tv);
  return cone > 0.0 ? pow(min(cone, 1.0), p) : 0.0;
}
// Sines as sqrt(1 - c^2), as TressFX 4 has them: digits are lost where the strand points at the light or the eye.
float plain_cone(float tl, float tv, float lv, float p) {
  float cone = sqrt(1.0 - tl * tl) * sqrt(1.0 - tv * tv) - tl * tv;
  return cone > 0.0 ? pow(min(cone, 1.0), p) : 0.0;
}
// As it is printed, for light vectors that point along the light's way: greatest where the eye is on the light's side.
float printed_sum(float tl, float tv, float lv, float p) {
  float cone = sqrt(max(1.0 - tl * tl, 0.0)) * sqrt(max(1.0 - tv * tv, 0.0)) + tl * tv;
  return cone > 0.0 ? pow(min(cone, 1.0), p) : 0.0;
}
// Scheuermann, "Hair Rendering and Shading", SIGGRAPH 2004 (sketch): the sine to the half-way vector. Four times the power is
// about as wide near the cone.
float half_way_sine(float tl, float tv, float lv, float p) {
  float th = (tl + tv) * inversesqrt(max(2.0 + 2.0 * lv, 1e-12));
  return smoothstep(-1.0, 0.0, th) * pow(max(1.0 - th * th, 0.0), 2.0 * p);
}

float kajiya_kay_lobe(float tl, float tv, float lv, float p) { return KAJIYA_KAY(tl, tv, lv, p); }
