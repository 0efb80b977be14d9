// SPDX-License-Identifier: Apache-2.0
// What may lie under water, drawn wider than the frame by GUARD: refracted rays meet what the frame's lower edge cuts off.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"

void main() {
  write_surface();
  gl_Position = clip_from_world * vec4(out_position, 1.0);
  gl_Position.xy /= GUARD;
}
