// SPDX-License-Identifier: Apache-2.0
// The smart blur over the square of pixels within RADIUS.
#include "blur.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(strand_of, pixel, 0);
  Blur blur = Blur(texelFetch(frame, pixel, 0), 1.0);
  for (int y = -RADIUS; y <= RADIUS && here.w > 0.0; ++y)
    for (int x = -RADIUS; x <= RADIUS; ++x)
      if (x != 0 || y != 0) tap(blur, here, pixel + ivec2(x, y));
  out_color = blur.sum / blur.taps;
}
