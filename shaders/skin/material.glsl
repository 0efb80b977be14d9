// SPDX-License-Identifier: Apache-2.0
// What the scene says of the skin that is drawn. Lengths of the profile are in millimetres, the world is in metres.
#define FRAME_MEMBERS ivec4 light_casts[max_lights]; mat4 casting_clip_from_world[max_lights]; mat4 clip_from_view;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "profile_numbers.glsl"

layout(binding = 4) uniform sampler2D skin_albedo;
layout(binding = 5) uniform sampler2D skin_normal;
layout(binding = 6) uniform sampler2D skin_specular;   // red: factor of `specular`; green: of `roughness`
layout(binding = 7) uniform sampler2D skin_epidermal;
layout(binding = 8) uniform sampler2D skin_subdermal;  // alpha: how much light comes through

struct SkinPoint {
  vec3 position, smooth_normal, normal;  // world; `normal`: with the normal map
  vec2 uv;
  vec3 albedo;
};

// Clement's melanin: towards the albedo times its luminance. His weights .33, .59, .11 sum to 1.03; .30 is meant.
vec3 with_melanin(vec3 albedo) {
#ifdef MELANIN
  return albedo * mix(vec3(1.0), albedo * dot(albedo, vec3(0.30, 0.59, 0.11)), melanin);
#else
  return albedo;
#endif
}

SkinPoint skin_point() {
  SurfacePoint point = surface_point();
#ifdef NORMAL_MAP
  vec3 bent = point.world_from_tangent * decode_normal(texture(skin_normal, point.uv).xyz);
#else
  vec3 bent = point.normal;
#endif
  return SkinPoint(point.position, point.normal, bent, point.uv, with_melanin(texture(skin_albedo, point.uv).rgb));
}

// Towards a light, and its irradiance at normal incidence here.
struct ArrivingLight {
  vec3 direction, irradiance;
};
ArrivingLight arriving_light(int i, vec3 position) {
  vec3 towards = light_position[i].xyz - position * light_position[i].w;
  float squared = max(dot(towards, towards), 1e-8);
  return ArrivingLight(towards * inversesqrt(squared), light_radiance[i].rgb * (light_position[i].w > 0.0 ? 1.0 / squared : 1.0));
}
