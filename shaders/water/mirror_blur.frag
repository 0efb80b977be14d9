// SPDX-License-Identifier: Apache-2.0
// The mirror's picture, blurred more from left to right than up and down: 9 x 3 Gaussian, deviations of 2 and 0.7 texels. Colours
// are multiplied by how much of the texel shows something. As RGBM, all of it shows something: the background where nothing is.
#ifdef RGBM
#define FRAME_MEMBERS vec4 background;
#include "../common/frame.glsl"
#include "rgbm8/rgbm8.glsl"
#endif

layout(binding = 4) uniform sampler2D mirrored;  // alpha 1 where there is something, else all 0
layout(location = 0) out vec4 out_color;

void main() {
  ivec2 last = textureSize(mirrored, 0) - 1, pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -4; x <= 4; ++x) {
      float weight = exp(-0.125 * float(x * x) - 1.02041 * float(y * y));
      sum += weight * texelFetch(mirrored, clamp(pixel + ivec2(x, y), ivec2(0), last), 0);
      weights += weight;
    }
  out_color = sum / weights;
#ifdef RGBM
  out_color = rgbm_encoded(out_color.rgb + (1.0 - out_color.a) * background.rgb);
#endif
}
