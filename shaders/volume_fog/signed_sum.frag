// SPDX-License-Identifier: Apache-2.0
// One signed term of the thickness, for additive blending into a float target: metres of view depth times the hull's share.
#include "hull.glsl"

layout(binding = 4) uniform sampler2D view_depth;  // of the nearest solid
layout(location = 0) out float out_term;

void main() {
  float solid = texelFetch(view_depth, ivec2(gl_FragCoord.xy), 0).r;
  float depth = share * min(in_view_depth, solid);
  out_term = adds() ? depth : -depth;
}
