// SPDX-License-Identifier: Apache-2.0
// Draws cards, with what is one thing for a whole card: its number, and the two lights that count most. All passes over the
// same cards use this shader, so that they find each other's depth equal to the bit.
#include "../common/frame.glsl"
#include "../common/mesh_out.glsl"
#include "influential_lights.glsl"

layout(std430, binding = 14) readonly buffer Strands { vec4 strands[]; };  // [0] xyz = middle of the object; [1 + vertex] xyz =
                                                                           // direction painted on it, w = its card's number
layout(location = 4) out vec3 out_painted;  // world
layout(location = 5) flat out float out_card;
layout(location = 6) flat out ivec2 out_lights;
invariant gl_Position;

void main() {
  write_surface();
  vec4 strand = strands[1 + LAMINA_VERTEX_INDEX];
  out_painted = mat3(world_from_object) * strand.xyz;
  out_card = strand.w;
  out_lights = influential_lights((world_from_object * vec4(strands[0].xyz, 1.0)).xyz);
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
