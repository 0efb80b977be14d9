// SPDX-License-Identifier: Apache-2.0
// Shadows whose edges are `penumbra` millimetres wide, however large the picture or the map: the share of a disc of that width
// that light reaches. The disc lies in the plane of the surface; seen from the light it is round.
// Definition SHADOW_TAPS: samples of a light's map.
#include "../translucency/light_distance.glsl"
#include "../common/light_maps.glsl"

LIGHT_MAPS(shadow, 18)  // metres that light comes; 1e30 where it meets nothing

// 0: in shadow, 1: lit. `normal`: of the mesh.
float soft_shadow(int i, vec3 position, vec3 normal, vec3 to_light) {
#if CASTING_LIGHTS > 0
  int light = light_casts[i].x;
  float side = float(shadow_side());
  vec2 place = light_map_place(light, position) * side;
  float texel_m = light_map_width(light, position) / side;
  mat4 m = casting_clip_from_world[light];
  vec3 right = normalize(vec3(m[0].x, m[1].x, m[2].x)), down = normalize(vec3(m[0].y, m[1].y, m[2].y));
  float cosine = max(dot(normal, to_light), 0.15);
  vec2 slope = vec2(dot(normal, right), dot(normal, down)) / cosine;  // of the plane: metres towards the light a metre across
  float radius_m = 0.0005 * penumbra;
  float come = light_distance(light_position[i], position) - texel_m * (0.5 + length(slope)) - 0.0001;
  float lit = 0.0;
  for (int tap = 0; tap < SHADOW_TAPS; ++tap) {
    vec2 across = disc_place(tap, SHADOW_TAPS) * radius_m;
    ivec2 texel = ivec2(floor(place + across / texel_m));
    vec2 middle = (vec2(texel) + 0.5 - place) * texel_m;  // what the texel shows lies here
    bool inside = texel == clamp(texel, ivec2(0), ivec2(shadow_side() - 1));
    float blocked_after = shadow_map(light, clamp(texel, ivec2(0), ivec2(shadow_side() - 1))).r;
    lit += !inside || light < 0 || blocked_after >= come + dot(slope, middle) ? 1.0 : 0.0;
  }
  return lit / float(SHADOW_TAPS);
#else
  return 1.0;
#endif
}
