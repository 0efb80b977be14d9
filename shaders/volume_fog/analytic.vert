// SPDX-License-Identifier: Apache-2.0
// A hull's face by its view depth, and the ray to it in the hull's own space.
#include "../common/frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) out float out_view_depth;
layout(location = 1) out vec3 out_position;  // object space
layout(location = 2) flat out vec3 out_eye;  // object space

void main() {
  gl_Position = clip_from_world * (world_from_object * vec4(position, 1.0));
  out_view_depth = gl_Position.w;
  out_position = position;
  out_eye = (inverse(world_from_object) * vec4(eye_world.xyz, 1.0)).xyz;
}
