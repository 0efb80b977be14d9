// SPDX-License-Identifier: Apache-2.0
// The smart blur: a pixel that hair covers becomes the mean of such pixels about as far away; what hair does not cover neither
// gives nor takes. A killed pixel counts, and so the background comes through as far as the hair lets it.
#include "../common/frame.glsl"

layout(binding = 4) uniform sampler2D frame;
layout(binding = 5) uniform sampler2D strand_of;  // of strands.frag
layout(location = 0) out vec4 out_color;

struct Blur {
  vec4 sum;
  float taps;
};

// Adds the pixel if hair covers it within DEPTH_M of `here`.
void tap(inout Blur blur, vec4 here, ivec2 pixel) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(frame, 0)))) return;
  vec4 there = texelFetch(strand_of, pixel, 0);
  if (there.w == 0.0 || abs(there.z - here.z) > DEPTH_M) return;
  blur.sum += texelFetch(frame, pixel, 0);
  blur.taps += 1.0;
}
