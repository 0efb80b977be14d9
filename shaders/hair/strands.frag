// SPDX-License-Identifier: Apache-2.0
// Where hair covers the picture at all, killed pixels too: which way the nearest strand runs on the screen, and how far away.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "cards_in.glsl"
#include "strand.glsl"

layout(binding = 4) uniform sampler2D OPACITY;
layout(binding = 6) uniform sampler2D depth;
layout(location = 0) out vec4 out_strand;  // xy in pixels, unit; z = view depth in metres; w = 1

void main() {
  if (texture(OPACITY, in_uv).a < 1.0 / 255.0 || gl_FragCoord.z > texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r) discard;
  SurfacePoint at = surface_point();
  vec4 here = clip_from_world * vec4(at.position, 1.0), on = clip_from_world * vec4(DIRECTION(at), 0.0);
  vec2 along = (on.xy * here.w - here.xy * on.w) * frame_size_px.xy;  // the derivative of xy / w, but for a factor
  float squared = dot(along, along);
  out_strand = vec4(squared > 0.0 ? along * inversesqrt(squared) : vec2(0.0, 1.0), here.w, 1.0);
}
