// SPDX-License-Identifier: Apache-2.0
// What both ways of drawing a mesh (on screen and unwrapped) hand to the fragment stage.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

layout(location = 0) out vec3 out_position;  // world
layout(location = 1) out vec3 out_normal;    // world, not normalized
layout(location = 2) out vec4 out_tangent;   // world, w = handedness
layout(location = 3) out vec2 out_uv;

void write_surface() {
  out_position = (world_from_object * vec4(position, 1.0)).xyz;
  out_normal = mat3(world_from_object_normal) * normal;
  // A mirroring transform inverts the handedness of the frame.
  float mirrored = determinant(mat3(world_from_object)) < 0.0 ? -1.0 : 1.0;
  out_tangent = vec4(mat3(world_from_object) * tangent.xyz, tangent.w * mirrored);
  out_uv = uv;
}
