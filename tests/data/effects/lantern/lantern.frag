// SPDX-License-Identifier: Apache-2.0
// The lamp shade: diffuse light, shadowed, the glow from inside through its holes, and what it mirrors at its foot.
#define FRAME_MEMBERS mat4 casting_clip_from_world[8]; mat4 mirror_clip_from_world;
#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"

layout(std140, binding = 3) uniform Effect {
  int tint;     // 0 warm, 1 cold
  float level;  // of the scene, in metres
  float glow;
};
layout(binding = 4) uniform sampler2D shade;
layout(binding = 5) uniform sampler2D grain;
layout(binding = 6) uniform sampler2D falloff;
#ifdef SHADOW
layout(binding = 7) uniform sampler2D shadow_0;
#endif
#ifdef MIRROR
layout(binding = 8) uniform sampler2D mirrored;
#else
layout(binding = 8) uniform sampler2D sky;
#endif
layout(location = 0) out vec4 out_color;

// The point's place in a view's picture, 0 to 1, and its depth.
vec3 place_in(mat4 clip_from_world, vec3 position) {
  vec4 clip = clip_from_world * vec4(position, 1.0);
  return vec3(clip.xy / clip.w * 0.5 + 0.5, clip.z / clip.w);
}

void main() {
  vec3 normal = normalize(in_normal);
  vec4 base = texture(shade, in_uv);
  vec3 light = diffuse_light(normal, in_position);
#ifdef SHADOW
  vec3 there = place_in(casting_clip_from_world[0], in_position);
  if (there.z > texture(shadow_0, there.xy).r + 0.005) light = ambient.rgb;
#endif
  vec3 color = base.rgb * texture(grain, in_uv).r * light;
#ifdef HOLES
  vec3 inside = tint == 0 ? vec3(1.0, 0.7, 0.4) : vec3(0.5, 0.7, 1.0);
  color += inside * (base.a * glow);
#endif
  float foot = 1.0 - texture(falloff, vec2(clamp((in_position.y - level) / 2.4, 0.0, 1.0), 0.5)).r;
#ifdef MIRROR
  vec3 reflected = texture(mirrored, place_in(mirror_clip_from_world, in_position).xy).rgb;
#else
  vec3 reflected = texture(sky, vec2(0.5)).rgb;
#endif
  out_color = vec4(mix(color, reflected, 0.4 * foot), 1.0);
}
