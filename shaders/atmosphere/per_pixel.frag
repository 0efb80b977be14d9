// SPDX-License-Identifier: Apache-2.0
// The air before each pixel of the frame: L = L0 F_ex + L_in (James and Green, "Real-Time Animated Translucency", GDC 2004, after
// Hoffman and Preetham), each pixel's ray marched in VIEW_STEPS steps, and sunlight's
// own path integrated at each, or read from a table where TRANSMITTANCE_TABLE_BINDING is defined.
#define FRAME_MEMBERS mat4 view_from_world, clip_from_view;
#include "common/frame.glsl"
#include "air_march.glsl"
#include "seen_ray.glsl"
layout(binding = 4) uniform sampler2D frame;
layout(binding = 5) uniform sampler2D view_depth;
layout(location = 0) out vec4 out_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float along_axis;
  AirRay ray = seen_ray(gl_FragCoord.xy, along_axis);
  vec2 span = seen_span(ray, texelFetch(view_depth, pixel, 0).r, along_axis);
  Scattered air = march(ray, span, VIEW_STEPS, direction_to_sun());
  vec4 behind = texelFetch(frame, pixel, 0);
  out_color = vec4(behind.rgb * air.transmittance + air.light, behind.a);
}
