// SPDX-License-Identifier: Apache-2.0
// Draws a mesh on the screen, and hands on the apertures of its vertices where they are not in maps.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"

#ifndef APERTURE_MAP
layout(std430, binding = 3) readonly buffer Apertures { vec4 apertures[]; };  // [vertex * APERTURES + i]
layout(location = 4) out vec4 out_aperture[APERTURES];
#endif

void main() {
  write_surface();
#ifndef APERTURE_MAP
  for (int i = 0; i < APERTURES; ++i) out_aperture[i] = apertures[LAMINA_VERTEX_INDEX * APERTURES + i];
#endif
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
