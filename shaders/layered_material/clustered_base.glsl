// SPDX-License-Identifier: Apache-2.0
// The inner layer's disc by seven fetches in place of 13: clusters of taps that were blurred once for a scene (blurred_cluster.frag), each
// at its own middle, which moves out with the ray's length as the taps do. Only how a cluster's taps lie around its middle is
// that of one length.
// Needs one_fetch.glsl.
#include "clustered_taps.glsl"

layout(binding = 8) uniform sampler2D cluster_0;
layout(binding = 9) uniform sampler2D cluster_1;
layout(binding = 10) uniform sampler2D cluster_2;
layout(binding = 11) uniform sampler2D cluster_3;
layout(binding = 21) uniform sampler2D cluster_4;

// The middles of the seven, and how many taps each stands for.
const vec2 cluster_at[7] = vec2[7](vec2(0.2537155, 0.0322125), vec2(-0.4799037, -0.6453783), vec2(-0.4496295, 0.5389265),
                                   vec2(0.329447, -0.686575), vec2(0.707938, 0.589740), vec2(-0.840144, -0.07358),
                                   vec2(0.96234, -0.194983));

// `radius`: of the disc, in texture coordinates.
vec4 clustered_base(vec2 center, vec2 radius, Footprint footprint) {
  vec4 first = fetch_of(cluster_0, center + cluster_at[0] * radius, footprint);
  vec4 sum = 3.0 * (fetch_of(cluster_1, center + cluster_at[1] * radius, footprint) - first);
  sum += 2.0 * (fetch_of(cluster_2, center + cluster_at[2] * radius, footprint) - first);
  sum += 2.0 * (fetch_of(cluster_3, center + cluster_at[3] * radius, footprint) - first);
  sum += 2.0 * (fetch_of(cluster_4, center + cluster_at[4] * radius, footprint) - first);
  sum += fetch_of(inner_albedo, center + cluster_at[5] * radius, footprint) - first;
  sum += fetch_of(inner_albedo, center + cluster_at[6] * radius, footprint) - first;
  return first + sum / 13.0;
}
