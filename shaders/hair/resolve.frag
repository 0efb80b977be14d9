// SPDX-License-Identifier: Apache-2.0
// The mean of a pixel's samples over what is behind them.
#include "../common/frame.glsl"

layout(binding = 4) uniform sampler2D sample_light;  // premultiplied; alpha 1 where there is hair
layout(location = 0) out vec4 out_color;

void main() {
  ivec2 side = textureSize(sample_light, 0) / ivec2(frame_size_px.xy), first = ivec2(gl_FragCoord.xy) * side;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < side.y; ++y)
    for (int x = 0; x < side.x; ++x) sum += texelFetch(sample_light, first + ivec2(x, y), 0);
  out_color = sum / float(side.x * side.y);
}
