// SPDX-License-Identifier: Apache-2.0
// Draws a mesh on the screen.
#include "frame.glsl"
#include "mesh_out.glsl"

void main() {
  write_surface();
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
