// SPDX-License-Identifier: Apache-2.0
// Where light enters: the normal there, and how far the light has come. Hery's depth map (RenderMan in Production, SIGGRAPH 2002
// course) with the normal that Fresnel's factor takes (Green, "Real-Time Animated Translucency", GDC 2004).
#include "light_map.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(location = 0) out vec4 out_entry;

void main() {
  float squared = dot(in_normal, in_normal);
  out_entry = vec4(squared > 1e-12 ? in_normal * inversesqrt(squared) : vec3(0.0), light_distance(this_light(), in_position));
}
