// SPDX-License-Identifier: Apache-2.0
// One depth sample and an exponential: Green, GPU Gems, 2004, chapter 16.
#include "medium.glsl"
#include "light_maps.glsl"
#include "one_path.glsl"

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  if (lit.map < 0) return vec3(max(cosine, 0.0));
  return exp(-extinction() * one_path(i, lit, normal, vec2(0.0))) * both_sides(cosine);
}
#include "through.glsl"
