// SPDX-License-Identifier: Apache-2.0
// The smart blur along the strand: RADIUS pixels to either side.
#include "blur.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(strand_of, pixel, 0);
  Blur blur = Blur(texelFetch(frame, pixel, 0), 1.0);
  // A step is a whole pixel along the longer axis, so that taps are different pixels.
  vec2 step_px = here.xy / max(max(abs(here.x), abs(here.y)), 1e-6);
  for (int i = 1; i <= RADIUS && here.w > 0.0; ++i) {
    ivec2 off = ivec2(floor(step_px * float(i) + 0.5));
    tap(blur, here, pixel + off);
    tap(blur, here, pixel - off);
  }
  out_color = blur.sum / blur.taps;
}
