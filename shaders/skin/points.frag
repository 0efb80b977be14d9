// SPDX-License-Identifier: Apache-2.0
// For the truth: where each pixel's surface is, its normal with the normal map, its albedo as it is filtered here, and its
// specular map.
#define OBJECT_MEMBERS ivec4 object_place;
#include "material.glsl"

layout(location = 0) out vec4 out_point;   // world; alpha: the object's place + 1
layout(location = 1) out vec4 out_normal;  // alpha: red of the specular map
layout(location = 2) out vec4 out_albedo;  // alpha: green of the specular map

void main() {
  SkinPoint point = skin_point();
  vec2 map = texture(skin_specular, point.uv).rg;
  out_point = vec4(point.position, float(object_place.x + 1));
  out_normal = vec4(point.normal, map.r);
  out_albedo = vec4(point.albedo, map.g);
}
