// SPDX-License-Identifier: Apache-2.0
// What may lie under water, drawn wider than the frame: refracted rays meet what the frame's lower edge cuts off.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"
#include "below_place.glsl"

void main() {
  write_surface();
  gl_Position = clip_from_world * vec4(out_position, 1.0);
  vec2 place = 0.5 * gl_Position.xy + 0.5 * gl_Position.w;
  gl_Position.xy = 2.0 * (place - below_first * gl_Position.w) / below_size - gl_Position.w;
}
