// SPDX-License-Identifier: Apache-2.0
// The depth of a hull's face as a code of CODE_BITS bits a channel, for additive blending. What is written, by definition:
//
//   SIGNED_CODES   whole numbers of both signs, into a float target
//   ONE_SIDE       1: what adds to the thickness, 0: what takes away; n / 255, into one target of 8 bits a channel
//   otherwise      n / 255 into one of two targets: what adds, what takes away
//
// DITHER dithers codes. SOLID_CODES: the nearest solid's depth is such a code too.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "../depth_encoding/codes.glsl"
#include "hull.glsl"
#include "reach.glsl"

#ifdef SOLID_CODES
layout(binding = 4) uniform sampler2D solid_codes;
#else
layout(binding = 4) uniform sampler2D view_depth;
#endif
#if defined(SIGNED_CODES) || defined(ONE_SIDE)
layout(location = 0) out vec4 out_code;
#else
layout(location = 0) out vec4 out_added;
layout(location = 1) out vec4 out_taken;
#endif

// The nearest solid's depth, in reaches.
float solid_depth(float reached) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef SOLID_CODES
  ivec3 code = ivec3(texelFetch(solid_codes, pixel, 0).rgb * 255.0 + 0.5);
  return float(joined_code(code, CODE_BITS)) / code_scale(CODE_BITS);
#else
  return texelFetch(view_depth, pixel, 0).r / reached;
#endif
}

void main() {
#ifdef ONE_SIDE
  if (adds() != (ONE_SIDE == 1)) discard;
#endif
  float reached = reached_m(reach);
  float depth = share * min(min(in_view_depth / reached, solid_depth(reached)), 1.0);
#ifdef DITHER
  // Faces that touch have the same depth, and so the same noise.
  float random = random_of(uvec3(gl_FragCoord.xy, floatBitsToUint(depth)));
  vec4 code = vec4(dithered_code(depth, random, CODE_BITS));
#else
  vec4 code = vec4(split_code(code_of(depth, CODE_BITS), CODE_BITS), 0.0);
#endif
#ifdef SIGNED_CODES
  out_code = adds() ? code : -code;
#elif defined(ONE_SIDE)
  out_code = code / 255.0;
#else
  out_added = adds() ? code / 255.0 : vec4(0.0);
  out_taken = adds() ? vec4(0.0) : code / 255.0;
#endif
}
