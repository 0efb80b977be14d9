// SPDX-License-Identifier: Apache-2.0
// The material of the nearest transparent surface at full rate, with light and background from a pattern of pixels that hold the
// one or the other, blended by hand. CHECKERBOARD, with DIRECTED_PAIRS, TWELVE_TAPS or else the mean of four; or QUAD_STIPPLE.
// Where no neighbour is of use, light is computed here, and background is the mean of what is there.
#define FRAME_MEMBERS mat4 clip_from_view;
#define OBJECT_MEMBERS ivec4 object_place;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "neighbours.glsl"
#include "pattern.glsl"
#include "surface.glsl"

layout(location = 0) out vec4 out_color;

vec4 cross_value(AskingSurface surface, ivec2 pixel, bool of_light, out float taken) {
  CrossValues ends;
  for (int i = 0; i < 4; ++i) {
    ends.value[i] = held_by(pixel + cross_ends[i]);
    ends.taken[i] = of_light ? light_weight(surface, pixel, cross_ends[i]) : background_weight(surface, pixel, cross_ends[i]);
  }
#if defined(DIRECTED_PAIRS)
  return directed_pairs(ends, taken);
#elif defined(TWELVE_TAPS)
  vec4 knights = vec4(0.0);
  bool all_knights = true;
  for (int i = 0; i < 8; ++i) {
    float weight =
        of_light ? light_weight(surface, pixel, knight_moves[i]) : background_weight(surface, pixel, knight_moves[i]);
    knights += held_by(pixel + knight_moves[i]);
    all_knights = all_knights && weight > 0.5;
  }
  bool all_ends = min(min(ends.taken[0], ends.taken[1]), min(ends.taken[2], ends.taken[3])) > 0.5;
  return twelve_taps(ends, knights, all_knights && all_ends, taken);
#else
  return mean_of_four(ends, taken);
#endif
}

#ifdef QUAD_STIPPLE
// Bilinear between the four pixels around that hold light, those of other surfaces left out.
vec4 stippled_light(AskingSurface surface, ivec2 pixel, out float taken) {
  ivec2 from = pixel - ivec2((pixel.x + PARITY + 1) & 1, (pixel.y + 1) & 1);
  vec2 part = vec2(pixel - from) * 0.5;
  vec4 sum = vec4(0.0);
  taken = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    vec2 near = mix(1.0 - part, part, vec2(step));
    ivec2 offset = from + 2 * step - pixel;
    float weight = near.x * near.y * light_weight(surface, pixel, offset);
    sum += weight * held_by(pixel + offset), taken += weight;
  }
  return taken > 0.0 ? sum / taken : vec4(0.0);
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = 1.0 / gl_FragCoord.w;
  AskingSurface asking = AskingSurface(float(object_place.x + 1), z, vec2(dFdx(z), dFdy(z)));
  if (gl_FragCoord.z > texelFetch(depth, pixel, 0).r) discard;
  TransparentSurface surface = transparent_surface();
  if (surface.opacity == 0.0) discard;
  vec4 own = held_by(pixel), light = own, background = own;
  if (holds_light(pixel)) {
    float taken;
    background = cross_value(asking, pixel, false, taken);
    if (taken == 0.0) {
      background = vec4(0.0);
      for (int i = 0; i < 4; ++i) background += 0.25 * held_by(pixel + cross_ends[i]);
    }
  } else {
    float taken;
#ifdef QUAD_STIPPLE
    light = stippled_light(asking, pixel, taken);
#else
    light = cross_value(asking, pixel, true, taken);
#endif
    if (taken < 1e-3) {
      SurfaceLight here = surface_light(surface.normal, in_position, gloss);
      light = vec4(here.diffuse, dot(here.specular, vec3(0.2126, 0.7152, 0.0722)));
    }
  }
  vec3 lit = surface.color * light.rgb + specular * light.a;
  out_color = vec4(mix(background.rgb, lit, surface.opacity), 1.0);
}
