// SPDX-License-Identifier: Apache-2.0
// A known amount of work for the timer's certificate: bilinear fetches, each at a place that depends on the one before. Their number is
// a uniform, since compilers unroll short loops of constant length, and 2x work is then not twice 1x.

layout(std140, binding = 3) uniform Work { ivec4 taps; };  // x
layout(binding = 4) uniform sampler2D source;
layout(location = 0) out vec4 out_color;

void main() {
  vec2 place = gl_FragCoord.xy / 256.0;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < taps.x; ++i) {
    vec4 texel = textureLod(source, place, 0.0);
    sum += texel;
    place = fract(place + texel.xy * 0.37 + 0.11);
  }
  out_color = sum / float(max(taps.x, 1));
}
