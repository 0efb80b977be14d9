// SPDX-License-Identifier: Apache-2.0
// The medium of the object that is drawn, and the light that reaches its surface. Includes the usual blocks.
#define FRAME_MEMBERS ivec4 light_casts[max_lights]; mat4 casting_clip_from_world[max_lights];
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "optics.glsl"

layout(std140, binding = 3) uniform Effect {
  float extinction_red;    // 1/m
  float extinction_green;
  float extinction_blue;
  float refraction_index;
  float multiple_scattering;
  float wrap;
  float thickness_scale;   // m
  float ramp_length;       // m
};
layout(binding = 4) uniform sampler2D translucent_albedo;
layout(location = 0) out vec4 out_color;

vec3 extinction() { return vec3(extinction_red, extinction_green, extinction_blue); }

struct Lit {
  vec3 direction;   // unit, towards the light
  vec3 irradiance;  // at normal incidence; what a Lambert albedo is multiplied by
  int map;          // place among the lights that cast, or -1
};

Lit light_at(int i, vec3 position) {
  vec3 to_light = light_position[i].xyz - position * light_position[i].w;
  float squared = max(dot(to_light, to_light), 1e-8);
  float falloff = light_position[i].w > 0.0 ? 1.0 / squared : 1.0;
  return Lit(to_light * inversesqrt(squared), light_radiance[i].rgb * falloff, light_casts[i].x);
}

vec3 unit_normal() {
  float squared = dot(in_normal, in_normal);
  return squared > 1e-12 ? in_normal * inversesqrt(squared) : vec3(0, 1, 0);
}

// What light on the surface, and light from behind that comes through, are multiplied by.
float both_sides(float cosine) { return max(cosine, 0.0) + wrapped_cosine(-cosine, wrap); }
