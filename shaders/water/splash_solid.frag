// SPDX-License-Identifier: Apache-2.0
// Adds up to 1 where the still water's level is inside an object, and to 0 elsewhere: on the way up from there, one leaves an object once
// more than one comes into it. What is further up than half the map, as a sky is, does not count.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
layout(std140, binding = 3) uniform Effect { float height, splash_size; };
layout(location = 0) out vec4 out_solid;

void main() {
  if (in_position.y <= height || in_position.y > height + 0.5 * splash_size) discard;
  out_solid = vec4(in_normal.y >= 0.0 ? 1.0 : -1.0, 0.0, 0.0, 1.0);
}
