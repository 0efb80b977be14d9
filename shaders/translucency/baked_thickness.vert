// SPDX-License-Identifier: Apache-2.0
// Draws a mesh on the screen, and hands on the thickness of its vertices where it is not in a map.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"

#ifndef THICKNESS_MAP
layout(std430, binding = 6) readonly buffer Thickness { float thickness[]; };  // m
layout(location = 4) out float out_thickness;
#endif

void main() {
  write_surface();
#ifndef THICKNESS_MAP
  out_thickness = thickness[LAMINA_VERTEX_INDEX];
#endif
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
