// SPDX-License-Identifier: Apache-2.0
// A fragment's absorbance, and that times the first four powers of its depth, for additive blending.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"
#include "clip_planes.glsl"
#include "moments.glsl"

layout(location = 0) out float out_absorbance;
#ifdef MOMENTS
layout(location = 1) out vec4 out_moments;
#endif

void main() {
  out_absorbance = absorbance_of(transparent_surface().opacity);
#ifdef MOMENTS
  vec2 planes = clip_planes();
  float depth = moment_depth(1.0 / gl_FragCoord.w, planes.x, planes.y), squared = depth * depth;
  out_moments = out_absorbance * vec4(depth, squared, squared * depth, squared * squared);
#endif
}
