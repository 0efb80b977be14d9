// SPDX-License-Identifier: Apache-2.0
// The maps of the lights that cast. A shader cannot have arrays of textures, so LIGHT_MAPS(entry, 8) declares the samplers entry_0,
// entry_1, ... of the lights that there are, from binding 8 on, and entry_map(light, texel), which reads one of them. A medium that scatters
// nothing reads none.
#ifndef LIGHT_MAPS_GLSL
#define LIGHT_MAPS_GLSL
#include "light_distance.glsl"

#ifndef SCATTERS
#undef CASTING_LIGHTS
#endif
#ifndef CASTING_LIGHTS
#define CASTING_LIGHTS 0
#endif
#if CASTING_LIGHTS > 0
#define MAP_SAMPLER_0(name, first) layout(binding = first + 0) uniform sampler2D name##_0;
#define MAP_TEXEL_0(name) if (light == 0) return texelFetch(name##_0, texel, 0);
#else
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
  }

LIGHT_MAPS(entry, 8)  // xyz = normal where light enters, or 0; w = how far it has come there, 1e30 where nothing is

int map_side() {
#if CASTING_LIGHTS > 0
  return textureSize(entry_0, 0).x;
#else
  return 1;
#endif
}

// Where a point lies in a light's map, in texels. It may lie outside.
vec2 map_place(int light, vec3 position) {
  vec4 clip = casting_clip_from_world[light] * vec4(position, 1.0);
  return (clip.xy / clip.w * 0.5 + 0.5) * float(map_side());
}

// Width in metres of a texel at this point: a row of the matrix says how much of the map a metre crosses.
float texel_width(int light, vec3 position) {
  mat4 m = casting_clip_from_world[light];
  float w = dot(vec4(m[0].w, m[1].w, m[2].w, m[3].w), vec4(position, 1.0));
  return 2.0 * w / (length(vec3(m[0].x, m[1].x, m[2].x)) * float(map_side()));
}

bool in_map(ivec2 texel) { return texel == clamp(texel, ivec2(0), ivec2(map_side() - 1)); }

// The i-th of `count` places spread evenly over a disc of radius 1 (Vogel's spiral of golden angles).
vec2 disc_place(int i, int count) {
  float angle = 2.39996323 * float(i);
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

#endif
