// SPDX-License-Identifier: Apache-2.0
// The mirror's picture, turned so that each point of the mirror stands at its own pixel, with the background where it is empty;
// and how far what it shows is. It is the pyramid's base.
#define FRAME_MEMBERS vec4 background;
#include "../common/frame.glsl"

layout(binding = 4) uniform sampler2D mirrored;  // alpha 1 where there is something
layout(binding = 5) uniform sampler2D mirrored_depth;
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_nearest;

void main() {
  ivec2 pixel = ivec2(textureSize(mirrored, 0).x - 1 - int(gl_FragCoord.x), int(gl_FragCoord.y));
  vec4 seen = texelFetch(mirrored, pixel, 0);
  out_color = vec4(mix(background.rgb, seen.rgb, seen.a), 1.0);
  out_nearest = seen.a > 0.5 ? texelFetch(mirrored_depth, pixel, 0).r : 1e30;
}
