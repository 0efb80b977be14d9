// SPDX-License-Identifier: Apache-2.0
// Clement's table: 0.5 PH^0.1 of four lobes, over N.H (x) and the slope (y). What does not fit into 0 to 1 is cut off.
// CENTRES: which values the texels hold; SIDE: texels along a side. STEPS, where it is given: values are rounded to that many.
#include "highlights.glsl"
layout(location = 0) out vec4 out_lobes;

// The first and the last texel hold 0 and 1.
vec2 right_place(vec2 pixel) { return (pixel - 0.5) / (float(SIDE) - 1.0); }
// Texels hold the values at their centres, so that none holds 1.
vec2 printed_place(vec2 pixel) { return pixel / float(SIDE); }

void main() {
  vec2 place = CENTRES(gl_FragCoord.xy);
  vec4 lobes = four_beckmann(max(place.x, 1e-3), clement_slopes * max(place.y, 0.03125));
  out_lobes = clamp(0.5 * exp2(0.1 * log2(max(lobes, 1e-30))), 0.0, 1.0);
#ifdef STEPS
  out_lobes = floor(out_lobes * STEPS + 0.5) / STEPS;
#endif
}
