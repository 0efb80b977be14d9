// SPDX-License-Identifier: Apache-2.0
// Draws a mesh unwrapped: texture coordinates as positions, so that the rasterizer lays the surface out in texture space
// (Oat 2006, section 4.5, figure 7). v runs down, as clip space does.
#include "frame.glsl"
#include "mesh_out.glsl"

void main() {
  write_surface();
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
