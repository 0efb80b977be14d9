// SPDX-License-Identifier: Apache-2.0
// Barre-Brisebois and Bouchard, "Approximating Translucency for a Fast, Cheap and Convincing Subsurface Scattering Look", GDC 2011:
// a lobe around the light's way on, bent by the normal, times how thin the object is. LOBE is raw_lobe, as
// printed, or normalised_lobe.
#include "medium.glsl"
#include "../back_light/normalised_lobe.glsl"
#include "../back_light/raw_lobe.glsl"
layout(binding = 5) uniform sampler2D translucent_thickness;

layout(constant_id = 0) const float distortion = 0.2;
layout(constant_id = 1) const float power = 4.0;
layout(constant_id = 2) const float strength = 1.0;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  vec3 to_eye = normalize(eye_world.xyz - in_position);
  float lobe = LOBE(dot(to_eye, lit.direction), cosine, dot(to_eye, normal), distortion, power);
  float back = strength * lobe * (1.0 - texture(translucent_thickness, in_uv).r);
  return vec3(max(cosine, 0.0) + back);
}
#include "through.glsl"
