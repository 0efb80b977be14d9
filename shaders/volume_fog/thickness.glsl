// SPDX-License-Identifier: Apache-2.0
// What the passes before summed at this pixel: metres of view depth times shares. Negative where holes stick out of the fog. By
// definition one of:
//
//   SIGNED_SUM         metres, one float
//   SIGNED_CODES       whole numbers of both signs
//   CODE_SUMS          two targets of 8 bits a channel: what adds, what takes away
//   DIFFERENCE_CODES   their difference, 128 standing for 0
//   SMALL_LINEAR       metres in a smaller target, interpolated
//   SMALL_DEPTH_AWARE  the same, but not across edges of solids
//
// Include after common/frame.glsl with clip_from_view.
#if defined(SIGNED_SUM) || defined(SMALL_LINEAR) || defined(SMALL_DEPTH_AWARE)
layout(binding = 6) uniform sampler2D thickness;
#else
#include "../depth_encoding/codes.glsl"
#include "reach.glsl"
#include "fog_numbers.glsl"

float metres_of(int code) { return float(code) / code_scale(CODE_BITS) * reached_m(reach); }
#endif

#ifdef SIGNED_SUM
float weighted_depth() { return texelFetch(thickness, ivec2(gl_FragCoord.xy), 0).r; }
#endif

#ifdef SIGNED_CODES
layout(binding = 6) uniform sampler2D code_sums;

float weighted_depth() {
  return metres_of(joined_code(ivec3(texelFetch(code_sums, ivec2(gl_FragCoord.xy), 0).rgb), CODE_BITS));
}
#endif

#ifdef CODE_SUMS
layout(binding = 6) uniform sampler2D added_codes;
layout(binding = 7) uniform sampler2D taken_codes;

int joined_sums(sampler2D sums) {
  ivec4 channels = ivec4(texelFetch(sums, ivec2(gl_FragCoord.xy), 0) * 255.0 + 0.5);
  return joined_dithered_code(channels, CODE_BITS);
}
float weighted_depth() { return metres_of(joined_sums(added_codes) - joined_sums(taken_codes)); }
#endif

#ifdef DIFFERENCE_CODES
layout(binding = 6) uniform sampler2D difference;

float weighted_depth() {
  ivec3 channels = ivec3(texelFetch(difference, ivec2(gl_FragCoord.xy), 0).rgb * 255.0 + 0.5) - 128;
  return metres_of(joined_code(channels, CODE_BITS));
}
#endif

#ifdef SMALL_LINEAR
float weighted_depth() { return textureLod(thickness, gl_FragCoord.xy * frame_size_px.zw, 0.0).r; }
#endif

#ifdef SMALL_DEPTH_AWARE
layout(binding = 7) uniform sampler2D view_depth;
layout(binding = 8) uniform sampler2D small_view_depth;

// Interpolated where the four texels and the pixel see one surface; else the texel whose solid is nearest in depth.
float weighted_depth() {
  float solid = texelFetch(view_depth, ivec2(gl_FragCoord.xy), 0).r;
  ivec2 last = textureSize(thickness, 0) - 1;
  vec2 at = gl_FragCoord.xy * frame_size_px.zw * vec2(last + 1) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 part = at - vec2(corner);
  float sum = 0.0, nearest = 0.0, least_gap = 3e38, most_gap = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1), texel = clamp(corner + offset, ivec2(0), last);
    vec2 weight = mix(1.0 - part, part, vec2(offset));
    float metres = texelFetch(thickness, texel, 0).r;
    float gap = abs(texelFetch(small_view_depth, texel, 0).r - solid);
    sum += weight.x * weight.y * metres;
    if (gap < least_gap) nearest = metres, least_gap = gap;
    most_gap = max(most_gap, gap);
  }
  return most_gap > EDGE_SHARE * solid ? nearest : sum;
}
#endif
