// SPDX-License-Identifier: Apache-2.0
// Thickness by the sum of all faces in the light's view, so that holes and hollows do not count. The sum is of the whole line; what
// of it lies before the point follows from where the light first enters and last leaves. That is exact on every face of up to two
// solid stretches on the line, and on the first and the last face of any number.
#include "medium.glsl"
#include "light_maps.glsl"
#include "one_path.glsl"
LIGHT_MAPS(leaving, 16)   // x = how far the light has come where it last leaves
LIGHT_MAPS(face_sum, 24)  // x = length of what is solid, m

float summed_path(int i, Lit lit, vec3 normal, float cosine) {
  ivec2 texel = ivec2(floor(map_place(lit.map, inner_place(lit, normal))));
  if (!in_map(texel)) return 0.0;
  float come = light_distance(light_position[i], in_position), solid = face_sum_map(lit.map, texel).x;
  float before = come - entry_map(lit.map, texel).w, behind = leaving_map(lit.map, texel).x - come;
  // A face that looks away from the light ends a stretch, and one that looks to it begins one.
  return max(cosine < 0.0 ? min(solid, before) : solid - behind - lit_bias(lit, cosine), 0.0);
}

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  if (lit.map < 0) return vec3(max(cosine, 0.0));
  return exp(-extinction() * summed_path(i, lit, normal, cosine)) * both_sides(cosine);
}
#include "through.glsl"
