// SPDX-License-Identifier: Apache-2.0
// Draws a mesh on the screen by its view depth: metres from the eye along the view's axis, whatever the depth buffer holds. Clip
// space's w is that depth in a perspective view.
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) out float out_view_depth;

void main() {
  gl_Position = clip_from_world * (world_from_object * vec4(position, 1.0));
  out_view_depth = gl_Position.w;
}
