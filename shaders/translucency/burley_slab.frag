// SPDX-License-Identifier: Apache-2.0
// One depth sample, and what Burley's profile lets through a slab of that thickness (optics.glsl).
#include "medium.glsl"
#include "light_maps.glsl"
#include "one_path.glsl"

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  if (lit.map < 0) return vec3(max(cosine, 0.0));
  vec3 reflectance = diffuse_reflectance(texture(translucent_albedo, in_uv).rgb, refraction_index);
  return slab_transmittance(extinction() * one_path(i, lit, normal, vec2(0.0)), reflectance) * both_sides(cosine);
}
#include "through.glsl"
