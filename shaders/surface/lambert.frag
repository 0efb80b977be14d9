// SPDX-License-Identifier: Apache-2.0
// An opaque diffuse surface: the albedo times N.L of the vertex normal.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(binding = 4) uniform sampler2D albedo;
layout(location = 0) out vec4 out_color;

void main() {
  vec3 light = diffuse_light(normalize(in_normal), in_position);
  out_color = vec4(texture(albedo, in_uv).rgb * light, 1.0);
}
