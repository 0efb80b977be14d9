// SPDX-License-Identifier: Apache-2.0
// The lights over the geometry buffer: where it has a surface, irradiance and the luminance of highlights, whose colour is lost;
// elsewhere the frame, which has been lit already.
#define FRAME_MEMBERS mat4 world_from_clip; mat4 view_from_world;
#include "../common/frame.glsl"
#include "light.glsl"

layout(binding = 4) uniform sampler2D surface_normal;
layout(binding = 5) uniform sampler2D surface_place;
layout(binding = 6) uniform sampler2D frame;
layout(location = 0) out vec4 out_light;

vec3 world_position(float view_depth) {
  vec2 ndc = gl_FragCoord.xy * frame_size_px.zw * 2.0 - 1.0;
  vec4 far = world_from_clip * vec4(ndc, 1.0, 1.0);
  vec3 along = far.xyz / far.w - eye_world.xyz;
  vec3 ahead = -vec3(view_from_world[0][2], view_from_world[1][2], view_from_world[2][2]);
  return eye_world.xyz + along * (view_depth / dot(along, ahead));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 place = texelFetch(surface_place, pixel, 0).rg;
  if (place.x == 0.0) {
    out_light = vec4(texelFetch(frame, pixel, 0).rgb, 0.0);
    return;
  }
  vec4 normal = texelFetch(surface_normal, pixel, 0);
  SurfaceLight light = surface_light(normalize(normal.xyz), world_position(place.y), normal.w);
  out_light = vec4(light.diffuse, dot(light.specular, vec3(0.2126, 0.7152, 0.0722)));
}
