// SPDX-License-Identifier: Apache-2.0
// The sky at the vertices of a grid over the picture, whose outer ones lie on its edge; a texel is a vertex.
#define FRAME_MEMBERS mat4 view_from_world, clip_from_view;
#include "common/frame.glsl"
#include "air_march.glsl"
#include "seen_ray.glsl"
layout(location = 0) out vec4 out_transmittance;
layout(location = 1) out vec4 out_light;

void main() {
  vec2 place_px = (gl_FragCoord.xy - 0.5) / float(GRID_SIDE - 1) * frame_size_px.xy;
  float along_axis;
  AirRay ray = seen_ray(place_px, along_axis);
  Scattered air = march(ray, seen_span(ray, 1e30, along_axis), VIEW_STEPS, direction_to_sun());
  out_transmittance = vec4(air.transmittance, 1.0);
  out_light = vec4(air.light, 1.0);
}
