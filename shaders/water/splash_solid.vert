// SPDX-License-Identifier: Apache-2.0
// What may stand in the water, seen from above on the map of splashes.
#define FRAME_MEMBERS mat4 world_from_clip;
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"
layout(std140, binding = 3) uniform Effect { float splash_size; };
#include "splash_map.glsl"

void main() {
  write_surface();
  gl_Position = vec4(2.0 * splash_place(out_position.xz) - 1.0, 0.5, 1.0);
}
