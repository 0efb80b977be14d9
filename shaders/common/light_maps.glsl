// SPDX-License-Identifier: Apache-2.0
// The maps of the lights that cast. A shader cannot have arrays of textures, so LIGHT_MAPS(entry, 8) declares the samplers
// entry_0, entry_1, ... of the lights that there are, from binding 8 on; entry_map(light, texel), which reads one of them; and
// entry_side(), the width of each in texels. Without a light that casts, no sampler is declared. Block Frame must have
// casting_clip_from_world.
#ifndef LIGHT_MAPS_GLSL
#define LIGHT_MAPS_GLSL

#ifndef CASTING_LIGHTS
#define CASTING_LIGHTS 0
#endif
#if CASTING_LIGHTS > 0
#define MAP_SIDE(name) int name##_side() { return textureSize(name##_0, 0).x; }
#define MAP_SAMPLER_0(name, first) layout(binding = first + 0) uniform sampler2D name##_0;
#define MAP_TEXEL_0(name) if (light == 0) return texelFetch(name##_0, texel, 0);
#else
#define MAP_SIDE(name) int name##_side() { return 1; }
#define MAP_SAMPLER_0(name, first)
#define MAP_TEXEL_0(name)
#endif
#if CASTING_LIGHTS > 1
#define MAP_SAMPLER_1(name, first) layout(binding = first + 1) uniform sampler2D name##_1;
#define MAP_TEXEL_1(name) if (light == 1) return texelFetch(name##_1, texel, 0);
#else
#define MAP_SAMPLER_1(name, first)
#define MAP_TEXEL_1(name)
#endif
#if CASTING_LIGHTS > 2
#define MAP_SAMPLER_2(name, first) layout(binding = first + 2) uniform sampler2D name##_2;
#define MAP_TEXEL_2(name) if (light == 2) return texelFetch(name##_2, texel, 0);
#else
#define MAP_SAMPLER_2(name, first)
#define MAP_TEXEL_2(name)
#endif
#if CASTING_LIGHTS > 3
#define MAP_SAMPLER_3(name, first) layout(binding = first + 3) uniform sampler2D name##_3;
#define MAP_TEXEL_3(name) if (light == 3) return texelFetch(name##_3, texel, 0);
#else
#define MAP_SAMPLER_3(name, first)
#define MAP_TEXEL_3(name)
#endif
#if CASTING_LIGHTS > 4
#define MAP_SAMPLER_4(name, first) layout(binding = first + 4) uniform sampler2D name##_4;
#define MAP_TEXEL_4(name) if (light == 4) return texelFetch(name##_4, texel, 0);
#else
#define MAP_SAMPLER_4(name, first)
#define MAP_TEXEL_4(name)
#endif
#if CASTING_LIGHTS > 5
#define MAP_SAMPLER_5(name, first) layout(binding = first + 5) uniform sampler2D name##_5;
#define MAP_TEXEL_5(name) if (light == 5) return texelFetch(name##_5, texel, 0);
#else
#define MAP_SAMPLER_5(name, first)
#define MAP_TEXEL_5(name)
#endif
#if CASTING_LIGHTS > 6
#define MAP_SAMPLER_6(name, first) layout(binding = first + 6) uniform sampler2D name##_6;
#define MAP_TEXEL_6(name) if (light == 6) return texelFetch(name##_6, texel, 0);
#else
#define MAP_SAMPLER_6(name, first)
#define MAP_TEXEL_6(name)
#endif
#if CASTING_LIGHTS > 7
#define MAP_SAMPLER_7(name, first) layout(binding = first + 7) uniform sampler2D name##_7;
#define MAP_TEXEL_7(name) if (light == 7) return texelFetch(name##_7, texel, 0);
#else
#define MAP_SAMPLER_7(name, first)
#define MAP_TEXEL_7(name)
#endif
#define LIGHT_MAPS(name, first) \
  MAP_SAMPLER_0(name, first) \
  MAP_SAMPLER_1(name, first) \
  MAP_SAMPLER_2(name, first) \
  MAP_SAMPLER_3(name, first) \
  MAP_SAMPLER_4(name, first) \
  MAP_SAMPLER_5(name, first) \
  MAP_SAMPLER_6(name, first) \
  MAP_SAMPLER_7(name, first) \
  vec4 name##_map(int light, ivec2 texel) { \
    MAP_TEXEL_0(name) \
    MAP_TEXEL_1(name) \
    MAP_TEXEL_2(name) \
    MAP_TEXEL_3(name) \
    MAP_TEXEL_4(name) \
    MAP_TEXEL_5(name) \
    MAP_TEXEL_6(name) \
    MAP_TEXEL_7(name) \
    return vec4(0.0); \
  } \
  MAP_SIDE(name)


// Where a point lies in a light's map, from 0 to 1. It may lie outside.
vec2 light_map_place(int light, vec3 position) {
  vec4 clip = casting_clip_from_world[light] * vec4(position, 1.0);
  return clip.xy / clip.w * 0.5 + 0.5;
}

// Width in metres of the whole map at this point: a row of the matrix says how much of the map a metre crosses.
float light_map_width(int light, vec3 position) {
  mat4 m = casting_clip_from_world[light];
  float w = dot(vec4(m[0].w, m[1].w, m[2].w, m[3].w), vec4(position, 1.0));
  return 2.0 * w / length(vec3(m[0].x, m[1].x, m[2].x));
}

// The i-th of `count` places spread evenly over a disc of radius 1 (Vogel's spiral of golden angles).
vec2 disc_place(int i, int count) {
  float angle = 2.39996323 * float(i);
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

#endif
