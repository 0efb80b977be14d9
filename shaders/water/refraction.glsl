// SPDX-License-Identifier: Apache-2.0
// Where a picture of what is below shows what a refracted ray meets. The picture is drawn for it, and is wider than the frame by
// GUARD each way: rays bend towards the frame's lower edge and beyond. With FRAME_BELOW it is the frame. REFRACTION: to_depth (down
// to the depth of what is behind the pixel, and again from what is found there, LANDINGS_BELOW times), marched (from there the first
// place along the ray that lies behind what the picture shows, in MARCH_STEPS steps, up to twice as far as the deepest of them),
// as_long_as (as long as the unrefracted way), unbent.
#define to_depth 0
#define as_long_as 1
#define unbent 2
#define marched 3
#include "refraction_way/refraction_way.glsl"

layout(binding = 7) uniform sampler2D below;  // metres along the view's axis, 0 where there is nothing; the sun's share
#ifndef FRAME_BELOW
layout(binding = 8) uniform sampler2D below_color;  // alpha 1 where there is something, else all 0
// From the frame's place, 0 to 1, to the picture's.
vec2 on_picture(vec2 place) { return (place - 0.5) / GUARD + 0.5; }
vec3 color_at(vec2 place) {
  vec4 seen = textureLod(below_color, on_picture(place), 0.0);
  return seen.rgb + (1.0 - seen.a) * background.rgb;
}
#else
layout(binding = 8) uniform sampler2D frame;
vec2 on_picture(vec2 place) { return place; }
vec3 color_at(vec2 place) { return textureLod(frame, place, 0.0).rgb; }
#endif

const float bottom_far_m = 1e4;
const float unknown_way_m = 8.0;  // where a ray is looked for whose pixel shows nothing below

struct Behind {
  vec2 place;       // on the frame; outside 0 to 1 beside it
  vec3 position;
  float view_depth;
  vec3 sun_share;
};

// What the picture shows in a place of the frame.
Behind behind_at(vec2 place) {
  ivec2 size = textureSize(below, 0);
  vec4 texel = texelFetch(below, clamp(ivec2(on_picture(place) * vec2(size)), ivec2(0), size - 1), 0);
  vec4 far = world_from_clip * vec4(place * 2.0 - 1.0, 1.0, 1.0);
  vec3 ray = (far.xyz / far.w - eye_world.xyz) * far.w;  // a metre along the view's axis
  float depth = texel.r > 0.0 ? min(texel.r, bottom_far_m) : bottom_far_m;
  return Behind(place, eye_world.xyz + depth * ray, depth, texel.gba);
}

// Where a point of the ray stands on the frame.
vec2 place_of(vec3 world, vec2 otherwise) {
  vec4 clip = clip_from_world * vec4(world, 1.0);
  return clip.w > 1e-4 ? clip.xy / clip.w * 0.5 + 0.5 : otherwise;
}

// The way to the place along the ray that is as deep as what was found.
float way_down(vec3 from, vec3 along, Behind found, Behind straight, bool under) {
  if (found.view_depth >= bottom_far_m) return unknown_way_m;
#if REFRACTION == as_long_as
  return distance(straight.position, from);
#else
  return under ? distance(straight.position, from) : way_to_depth(-along.y, max(from.y - found.position.y, 0.0));
#endif
}

#if REFRACTION == marched
// Whether a point of the ray lies behind what the picture shows, by less than `thick_m`: further behind, the ray passes behind it.
bool lies_behind(vec3 at, float thick_m, vec2 otherwise) {
  float off = (clip_from_world * vec4(at, 1.0)).w - behind_at(place_of(at, otherwise)).view_depth;
  return off > 0.0 && off < thick_m;
}

// The first place within `reach` along the ray that lies behind what the picture shows; the reach where none does.
float marched_way(vec3 from, vec3 along, float reach, vec2 otherwise) {
  float step_m = reach / float(MARCH_STEPS), before = 0.0, behind = reach;
  bool is_found = false;
  for (int i = 1; i <= MARCH_STEPS; ++i) {
    float way = step_m * float(i);
    bool is_behind = lies_behind(from + way * along, 6.0 * step_m, otherwise);
    before = is_found || is_behind ? before : way;
    behind = is_behind && !is_found ? way : behind;
    is_found = is_found || is_behind;
  }
  for (int i = 0; i < 5; ++i) {
    float way = 0.5 * (before + behind);
    bool is_behind = lies_behind(from + way * along, 6.0 * step_m, otherwise);
    before = is_behind ? before : way;
    behind = is_behind ? way : behind;
  }
  return is_found ? behind : reach;
}
#endif

// What the ray from a point of the surface meets. What is nearer than the water, or over it, is not behind it: then it is what
// stands behind the pixel, with the depth of that. Seen from under the water it is taken to be as far as that.
Behind refracted_behind(vec3 from, vec3 along, float own_depth, Behind straight, bool under) {
#if REFRACTION == unbent
  return straight;
#else
  Behind found = straight;
#if REFRACTION == as_long_as
  const int landings = 1;
#else
  const int landings = LANDINGS_BELOW;
#endif
  float reach = 0.0;
  for (int i = 0; i <= landings; ++i) {
    float way = min(way_down(from, along, found, straight, under), bottom_far_m);
    reach = max(reach, way);
#if REFRACTION == marched
    if (i == landings) way = under ? way : marched_way(from, along, 2.0 * reach, straight.place);
#else
    if (i == landings) break;
#endif
    vec2 place = place_of(from + way * along, straight.place), on = on_picture(place);
    // Beyond the picture's edges nothing is known: the ray bends less.
    vec2 inside = clamp(min(on, 1.0 - on) / 0.03, 0.0, 1.0);
    place = inside.x * inside.y > 0.0 ? mix(straight.place, place, inside.x * inside.y) : straight.place;
    Behind next = behind_at(place);
    bool is_behind = next.view_depth > own_depth && (under || next.position.y < from.y);
    found.place = is_behind ? next.place : found.place;
    found.position = is_behind ? next.position : found.position;
    found.view_depth = is_behind ? next.view_depth : found.view_depth;
    found.sun_share = is_behind ? next.sun_share : found.sun_share;
  }
  return found;
#endif
}
