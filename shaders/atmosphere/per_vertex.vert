// SPDX-License-Identifier: Apache-2.0
// Extinction and in-scatter of the air at each vertex, for the rasterizer to interpolate (James and Green, "Real-Time Animated
// Translucency", GDC 2004: "Rayleigh & Mie scattering in vertex shader").
#include "common/frame.glsl"
#include "air_march.glsl"
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 out_transmittance;
layout(location = 1) out vec3 out_light;

void main() {
  vec4 world = world_from_object * vec4(position, 1.0);
  gl_Position = clip_from_world * world;
  vec3 from_eye = world.xyz - eye_world.xyz;
  float distance = max(length(from_eye), 1e-6);
  AirRay ray = air_ray(eye_world.xyz - vec3(0.0, sea_level, 0.0), from_eye / distance);
  Scattered air = march(ray, span_in_air(ray, distance), VIEW_STEPS, direction_to_sun());
  out_transmittance = air.transmittance, out_light = air.light;
}
