// SPDX-License-Identifier: Apache-2.0
// The pyramid's base: the picture before any glass, and how near it is.
layout(binding = 4) uniform sampler2D frame;
layout(binding = 5) uniform sampler2D view_depth;
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_nearest;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  out_color = texelFetch(frame, pixel, 0);
  out_nearest = texelFetch(view_depth, pixel, 0).r;
}
