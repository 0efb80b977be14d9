// SPDX-License-Identifier: Apache-2.0
// What each pixel shows, for the offline truth.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(binding = 4) uniform sampler2D translucent_albedo;
layout(location = 0) out vec4 out_point;   // world; w = 1 where there is one
layout(location = 1) out vec4 out_normal;  // world, unit
layout(location = 2) out vec4 out_albedo;  // of scattering

void main() {
  float squared = dot(in_normal, in_normal);
  out_point = vec4(in_position, 1.0);
  out_normal = vec4(squared > 1e-12 ? in_normal * inversesqrt(squared) : vec3(0, 1, 0), 0.0);
  out_albedo = vec4(texture(translucent_albedo, in_uv).rgb, 1.0);
}
