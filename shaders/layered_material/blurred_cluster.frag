// SPDX-License-Identifier: Apache-2.0
// Cluster PLACE of the inner layer's taps around each texel, once for a scene: as it lies around the cluster's middle where the eye's ray is
// CLUSTERED_AT thicknesses long. Output: linear rgb, which the target encodes, and transparency.
#include "poisson_disc.glsl"
#include "clustered_taps.glsl"

layout(std140, binding = 3) uniform Effect { float thickness; };
layout(binding = 4) uniform sampler2D inner_albedo;
layout(location = 0) out vec4 out_base;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(inner_albedo, 0)), uv = gl_FragCoord.xy * texel;
  vec2 radius = CLUSTERED_AT * thickness * texel, middle = cluster_middle(PLACE);
  vec4 first = textureLod(inner_albedo, uv + (cluster_tap(cluster_first[PLACE]) - middle) * radius, 0.0), sum = vec4(0.0);
  for (int i = cluster_first[PLACE] + 1; i < cluster_first[PLACE + 1]; ++i)
    sum += textureLod(inner_albedo, uv + (cluster_tap(i) - middle) * radius, 0.0) - first;
  out_base = first + sum / cluster_weight(PLACE);
}
