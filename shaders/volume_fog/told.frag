// SPDX-License-Identifier: Apache-2.0
// For the truth: the frame behind the fog, and the sum of view depths that this variant came to (x), that its encoding comes to
// at every pixel of the frame (y), and that floats come to there (z). Metres of view depth times shares.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "thickness.glsl"

layout(binding = 4) uniform sampler2D frame;
#ifdef EXACT_SUM
layout(binding = 10) uniform sampler2D exact_thickness;
#endif
layout(location = 0) out vec4 out_behind;
layout(location = 1) out vec4 out_depths;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  out_behind = vec4(texelFetch(frame, pixel, 0).rgb, 1.0);
  float own = weighted_depth(), same_encoding = own, exact = own;
#ifdef EXACT_SUM
  exact = texelFetch(exact_thickness, pixel, 0).r;
#if defined(SMALL_LINEAR) || defined(SMALL_DEPTH_AWARE)
  same_encoding = exact;
#endif
#endif
  out_depths = vec4(own, same_encoding, exact, 1.0);
}
