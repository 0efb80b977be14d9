// SPDX-License-Identifier: Apache-2.0
// What the mirror shows, drawn wider than the frame.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"
#include "mirror_place.glsl"

void main() {
  write_surface();
  gl_Position = clip_from_world * vec4(out_position, 1.0);
  gl_Position.xy /= mirror_guard;
}
