// SPDX-License-Identifier: Apache-2.0
// The picture of what may lie under water, as refracted rays look it up: the nearest surfaces, those that they hide, and those behind
// them that look away from the eye, which a ray that bends may meet over a round thing's edge. It is wider than the frame by GUARD to
// the left and right, and by GUARD_DOWN of the frame's height below: rays bend there. With FRAME_BELOW it is the frame, one layer. The
// places of the frame are 0 to 1, the top first; beside it less and more.
#include "common/looks.glsl"
#if defined(FRAME_BELOW) || REFRACTION != marched
#define BELOW_LAYERS 1
#elif !defined(BELOW_LAYERS)
#define BELOW_LAYERS 3
#endif
const int first_layer = 0, hidden_layer = 1, turned_layer = 2;

// Metres along the view's axis, 0 where there is nothing; then the sun's share of the light.
layout(binding = 7) uniform sampler2D below;
#if BELOW_LAYERS > 1
layout(binding = 14) uniform sampler2D below_hidden;
layout(binding = 15) uniform sampler2D below_hidden_color;
layout(binding = 18) uniform sampler2D below_turned;
layout(binding = 19) uniform sampler2D below_turned_color;
#endif
#ifndef FRAME_BELOW
#include "below_place.glsl"
layout(binding = 8) uniform sampler2D below_color;  // alpha 1 where there is something, else all 0
#else
layout(binding = 8) uniform sampler2D frame;
vec2 below_place(vec2 place) { return place; }
#endif

const float bottom_far_m = 1e4;

struct Behind {
  vec2 place;
  vec3 position;
  float view_depth;
  vec3 sun_share;
  int layer;
};

vec4 below_texel(int layer, ivec2 texel) {
  texel = clamp(texel, ivec2(0), textureSize(below, 0) - 1);
#if BELOW_LAYERS > 1
  if (layer == hidden_layer) return texelFetch(below_hidden, texel, 0);
  if (layer == turned_layer) return texelFetch(below_turned, texel, 0);
#endif
  return texelFetch(below, texel, 0);
}
float far_where_nothing(float depth) { return depth > 0.0 ? min(depth, bottom_far_m) : bottom_far_m; }
float below_depth_at(int layer, vec2 place) {
  return far_where_nothing(below_texel(layer, ivec2(floor(below_place(place) * vec2(textureSize(below, 0))))).r);
}
// Between texels: the inverse of a plane's depth runs straight over a picture. Where texels are not of one surface, the nearest.
float smooth_depth_at(int layer, vec2 place) {
  vec2 at = below_place(place) * vec2(textureSize(below, 0)) - 0.5, share = fract(at);
  ivec2 low = ivec2(floor(at));
  vec4 four = 1.0 / vec4(far_where_nothing(below_texel(layer, low).r), far_where_nothing(below_texel(layer, low + ivec2(1, 0)).r),
                         far_where_nothing(below_texel(layer, low + ivec2(0, 1)).r), far_where_nothing(below_texel(layer, low + 1).r));
  float most = max(max(four.x, four.y), max(four.z, four.w)), least = min(min(four.x, four.y), min(four.z, four.w));
  vec2 rows = mix(four.xz, four.yw, share.x);
  float nearest = share.y < 0.5 ? (share.x < 0.5 ? four.x : four.y) : (share.x < 0.5 ? four.z : four.w);
  return 1.0 / (most < 1.05 * least ? mix(rows.x, rows.y, share.y) : nearest);
}

// Whether the four texels around a place are not of one surface. There the nearest one alone is read.
bool is_mixed_at(int layer, vec2 place) {
  ivec2 low = ivec2(floor(below_place(place) * vec2(textureSize(below, 0)) - 0.5));
  vec4 four = vec4(far_where_nothing(below_texel(layer, low).r), far_where_nothing(below_texel(layer, low + ivec2(1, 0)).r),
                   far_where_nothing(below_texel(layer, low + ivec2(0, 1)).r), far_where_nothing(below_texel(layer, low + 1).r));
  return max(max(four.x, four.y), max(four.z, four.w)) > 1.05 * min(min(four.x, four.y), min(four.z, four.w));
}
vec2 texel_middle(vec2 place) {
  vec2 size = vec2(textureSize(below, 0)), apart = (floor(below_place(place) * size) + 0.5) / size - below_place(place);
#ifdef FRAME_BELOW
  return place + apart;
#else
  return place + apart * below_size;
#endif
}

Behind behind_at(int layer, vec2 place) {
  vec4 texel = below_texel(layer, ivec2(floor(below_place(place) * vec2(textureSize(below, 0)))));
  vec4 far = world_from_clip * vec4(place * 2.0 - 1.0, 1.0, 1.0);
  vec3 ray = (far.xyz / far.w - eye_world.xyz) * far.w;  // a metre along the view's axis
  float depth = far_where_nothing(texel.r);
  return Behind(place, eye_world.xyz + depth * ray, depth, texel.gba, layer);
}

// The light of what a layer shows in a place, before the water takes of it; from a level of its pyramid.
vec3 below_light(int layer, vec2 place, float level) {
#ifdef FRAME_BELOW
  return textureLod(frame, place, level).rgb;
#else
  vec2 at = below_place(place);
  vec4 seen = vec4(0.0);
#if BELOW_LAYERS > 1
  if (layer == hidden_layer) seen = textureLod(below_hidden_color, at, level);
  if (layer == turned_layer) seen = textureLod(below_turned_color, at, level);
#endif
  if (layer == first_layer) seen = textureLod(below_color, at, level);
  return seen.a > 0.05 ? seen.rgb / seen.a : background.rgb;  // beside nothing a surface keeps its colour
#endif
}

// Red and blue may be seen elsewhere than green: that far from its place.
vec3 colours_below(int layer, vec2 place, vec2 red, vec2 blue, float level) {
  vec3 seen = below_light(layer, place, level);
#ifdef DISPERSION
  seen.r = below_light(layer, place + red, level).r, seen.b = below_light(layer, place + blue, level).b;
#endif
  return seen;
}

// Whether neighbours see the same surface, at places not far from each other.
bool is_seen_on(Behind found) {
  vec2 apart_px = (abs(dFdx(found.place)) + abs(dFdy(found.place))) * frame_size_px.xy;
  return abs(dFdx(float(found.layer))) + abs(dFdy(float(found.layer))) == 0.0 && max(apart_px.x, apart_px.y) < 6.0;
}
Looks looks_below(Behind found) {
#ifdef FRAME_BELOW
  vec2 texel = frame_size_px.zw;
#else
  vec2 texel = below_size / vec2(textureSize(below_color, 0));
#endif
  // Derivatives are taken before it is asked whether they are of use.
  Looks looks = looks_over(dFdx(found.place), dFdy(found.place), texel);
  return is_seen_on(found) ? looks : one_look(texel);
}
