// SPDX-License-Identifier: Apache-2.0
// A fragment weighted by what the layers before it let through, as moments tell it; for additive blending.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"
#include "clip_planes.glsl"
#include "moments.glsl"

layout(binding = 5) uniform sampler2D absorbance;
layout(binding = 6) uniform sampler2D moments;
layout(location = 0) out vec4 out_sums;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float total = texelFetch(absorbance, pixel, 0).r;
  vec2 planes = clip_planes();
  float depth = moment_depth(1.0 / gl_FragCoord.w, planes.x, planes.y);
  vec4 layer = shaded_surface();
  float through = 1.0;
  if (total > 0.0) through = moment_transmittance(total, texelFetch(moments, pixel, 0) / total, depth, BIAS, OVERESTIMATION);
  out_sums = vec4(layer.rgb, 1.0) * (layer.a * through);
}
