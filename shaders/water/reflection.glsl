// SPDX-License-Identifier: Apache-2.0
// Where the mirror's picture shows what a reflected ray meets. A ray that leaves along the mirror's own normal is seen in the same
// place however far it goes; of all others the place depends on the distance. REFLECTION: by_depth (as far as what the picture
// shows there, found in LANDINGS steps), by_march (the first place along the ray that lies behind what the picture shows, in
// MIRROR_STEPS steps), by_distance (REFLECTION_DISTANCE metres), by_direction (far away), sky_alone.
#define by_depth 0
#define by_distance 1
#define by_direction 2
#define sky_alone 3
#define by_march 4

#include "common/looks.glsl"
#include "mirror_place.glsl"
#if REFLECTION != sky_alone
layout(binding = 5) uniform sampler2D reflection;
#endif
#if REFLECTION == by_depth || REFLECTION == by_march
layout(binding = 6) uniform sampler2D mirrored_depth;  // metres along the view's axis; 0 where there is nothing
#endif

const float mirrored_far_m = 1e4;

vec2 mirror_place(vec3 world) {
  vec4 clip = mirror_clip_from_world * vec4(world, 1.0);
  return clip.w > 1e-4 ? clip.xy / (clip.w * mirror_guard) * 0.5 + 0.5 : vec2(-1.0);
}
float mirror_depth_of(vec4 world) { return (mirror_clip_from_world * world).w; }

#if REFLECTION == by_depth || REFLECTION == by_march
float mirrored_depth_at(vec2 place) {
  ivec2 size = textureSize(mirrored_depth, 0);
  float found = texelFetch(mirrored_depth, clamp(ivec2(place * vec2(size)), ivec2(0), size - 1), 0).r;
  return found > 0.0 ? found : mirrored_far_m;
}
#endif

#if REFLECTION == by_march
// Steps are even on the picture, where the inverse of depth runs straight. What lies before the water's point is not met.
float reflected_way(vec3 from, vec3 along) {
  float start = mirror_depth_of(vec4(from, 1.0)), ahead = mirror_depth_of(vec4(along, 0.0));
  float end = start + mirrored_far_m * ahead;
  // Towards the mirrored eye: as far as a way that does not pass it.
  end = max(end, 0.2 * start);
  float reach = abs(ahead) > 1e-4 ? min((end - start) / ahead, mirrored_far_m) : mirrored_far_m;
  vec2 first = mirror_place(from), last = mirror_place(from + reach * along);
  float before = 0.0, behind = 1.0;
  bool is_found = false;
  for (int i = 1; i <= MIRROR_STEPS && !is_found; ++i) {
    float t = float(i) / float(MIRROR_STEPS), depth = 1.0 / mix(1.0 / start, 1.0 / end, t);
    float seen = mirrored_depth_at(mix(first, last, t));
    bool is_behind = depth >= seen && seen > start && seen < mirrored_far_m;
    before = is_found || is_behind ? before : t;
    behind = is_behind && !is_found ? t : behind;
    is_found = is_found || is_behind;
  }
  for (int i = 0; i < 4; ++i) {
    float t = 0.5 * (before + behind), depth = 1.0 / mix(1.0 / start, 1.0 / end, t), seen = mirrored_depth_at(mix(first, last, t));
    bool is_behind = depth >= seen && seen > start && seen < mirrored_far_m;
    before = is_behind ? before : t;
    behind = is_behind ? t : behind;
  }
  float t = is_found ? behind : 1.0, depth = 1.0 / mix(1.0 / start, 1.0 / end, t);
  return abs(ahead) > 1e-4 ? min((depth - start) / ahead, mirrored_far_m) : mirrored_far_m;
}
#elif REFLECTION == by_depth
// How far the ray goes until it is as deep as what the picture shows where it is. What lies before the water's point is not
// reflected by it: the ray goes on as before.
float reflected_way(vec3 from, vec3 along) {
  float start = mirror_depth_of(vec4(from, 1.0)), ahead = mirror_depth_of(vec4(along, 0.0));
  float found = mirrored_depth_at(mirror_place(from)), way = mirrored_far_m;
  for (int i = 0; i < LANDINGS; ++i) {
    way = found > start && ahead > 1e-4 ? min((found - start) / ahead, mirrored_far_m) : way;
    found = mirrored_depth_at(mirror_place(from + way * along));
  }
  return found > start && ahead > 1e-4 ? min((found - start) / ahead, mirrored_far_m) : way;
}
#elif REFLECTION == by_distance
float reflected_way(vec3 from, vec3 along) { return REFLECTION_DISTANCE; }
#else
float reflected_way(vec3 from, vec3 along) { return mirrored_far_m; }
#endif

#if REFLECTION != sky_alone
// What the mirror's picture shows in a place. What is outside the picture is not known: the sky.
vec3 mirror_look(vec2 place, vec3 sky_light_there) {
#ifdef RGBM
  vec4 seen = vec4(rgbm_decoded(textureLod(reflection, place, 0.0)), 1.0);
#else
  vec4 seen = textureLod(reflection, place, 0.0);
#endif
  vec2 inside = clamp(min(place, 1.0 - place) / 0.01, 0.0, 1.0);
  return mix(sky_light_there, seen.rgb + (1.0 - seen.a) * sky_light_there, inside.x * inside.y);
}
#endif

// The light that comes along the reflected ray. Rays that would meet water again are taken along its level.
vec3 reflected_light(vec3 from, vec3 along) {
  along = normalize(vec3(along.x, max(along.y, 1e-3), along.z));
  vec3 sky_there = sky_seen(along);
#if REFLECTION == sky_alone
  return sky_there;
#else
  vec2 place = mirror_place(from + reflected_way(from, along) * along);
  vec2 right = dFdx(place), down = dFdy(place), size = vec2(textureSize(reflection, 0));
  vec2 apart = (abs(right) + abs(down)) * frame_size_px.xy;
  Looks looks = looks_over(right, down, 1.0 / size);
  if (max(apart.x, apart.y) > 16.0) looks = one_look(1.0 / size);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) sum += 0.25 * mirror_look(place + look_at(looks, i), sky_there);
#ifndef MIRROR_BLURRED
  vec2 x = vec2(looks.texel.x, 0.0), y = vec2(0.0, looks.texel.y);
  sum += looks.sharpened.x * (2.0 * sum - mirror_look(place - x, sky_there) - mirror_look(place + x, sky_there)) +
         looks.sharpened.y * (2.0 * sum - mirror_look(place - y, sky_there) - mirror_look(place + y, sky_there));
#endif
  return max(sum, vec3(0.0));
#endif
}
