// SPDX-License-Identifier: Apache-2.0
// The deferred light of the hair that the first pass left, over the picture; nothing elsewhere.
#define FRAME_MEMBERS mat4 world_from_clip;
#include "../common/frame.glsl"
#include "lighting.glsl"

layout(binding = 4) uniform sampler2D shape;
layout(binding = 5) uniform sampler2D colour;
layout(binding = 6) uniform sampler2D depth;
layout(location = 0) out vec4 out_color;  // premultiplied

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 normal = texelFetch(shape, pixel, 0), albedo = texelFetch(colour, pixel, 0);
  out_color = vec4(0.0);
  if (normal.w == 0.0) return;
  vec2 clip = gl_FragCoord.xy / vec2(textureSize(shape, 0)) * 2.0 - 1.0;
  vec4 world = world_from_clip * vec4(clip, texelFetch(depth, pixel, 0).r, 1.0);
  vec3 position = world.xyz / world.w;
  out_color = vec4(blinn_phong(position, normalize(normal.xyz), normalize(eye_world.xyz - position), albedo.rgb, normal.w, albedo.a), 1.0);
}
