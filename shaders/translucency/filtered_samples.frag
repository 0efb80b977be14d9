// SPDX-License-Identifier: Apache-2.0
// Several samples of the depth map over a disc. What is averaged is the light that comes through, not the depth: across a step in
// depth the mean depth would let through what neither side does.
#include "medium.glsl"
#include "light_maps.glsl"
#include "one_path.glsl"

layout(constant_id = 0) const int samples = 9;
layout(constant_id = 1) const float sample_radius = 2.5;  // texels

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  if (lit.map < 0) return vec3(max(cosine, 0.0));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < samples; ++k) sum += exp(-extinction() * one_path(i, lit, normal, sample_radius * disc_place(k, samples)));
  return sum / float(samples) * both_sides(cosine);
}
#include "through.glsl"
