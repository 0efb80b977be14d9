// SPDX-License-Identifier: Apache-2.0
// Fog over the frame: premultiplied, for blending, or with READ_FRAME put over the frame that it reads.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "color.glsl"
#include "ray.glsl"
#include "thickness.glsl"

#ifdef READ_FRAME
layout(binding = 9) uniform sampler2D frame;
#endif
layout(location = 0) out vec4 out_color;

void main() {
  float depth = max(weighted_depth(), 0.0);  // holes may stick out of the fog
#ifdef READ_FRAME
  vec4 fog = fog_of(depth * ray_length_per_depth());
  out_color = fog + (1.0 - fog.a) * texelFetch(frame, ivec2(gl_FragCoord.xy), 0);
#else
  if (depth == 0.0) discard;
  out_color = fog_of(depth * ray_length_per_depth());
#endif
}
