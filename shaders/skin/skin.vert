// SPDX-License-Identifier: Apache-2.0
// Draws skin on the screen, with its baked curvature.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"

layout(std430, binding = 14) readonly buffer Curvatures { float curvatures[]; };  // 1/mm, of each vertex
layout(location = 4) out float out_curvature;

void main() {
  write_surface();
  out_curvature = curvatures[LAMINA_VERTEX_INDEX];
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
