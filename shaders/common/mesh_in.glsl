// SPDX-License-Identifier: Apache-2.0
// The fragment stage's side of mesh_out.glsl.

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec2 in_uv;

SurfacePoint surface_point() {
  vec3 n = normalize(in_normal);
  return SurfacePoint(in_position, n, tangent_frame(n, in_tangent), in_uv);
}
