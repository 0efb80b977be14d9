// SPDX-License-Identifier: Apache-2.0
// One direction (AXIS) of a blur in texture space that is another one in each channel, with stretch correction. LINE and REACH
// name the kernel; HALF_TAPS is its taps on each side.
#include "channel_taps.glsl"

layout(binding = 4) uniform sampler2D source;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_blurred;

void main() {
  vec2 size = vec2(textureSize(source, 0)), middle_at = gl_FragCoord.xy / size;
  float texel_mm = max(dot(texelFetch(stretch, ivec2(gl_FragCoord.xy), 0).xy, AXIS), 1e-4), reach = REACH();
  vec3 middle = texture(source, middle_at).rgb, sum = vec3(0.0);
  for (int i = 1; i <= HALF_TAPS; ++i) {
    vec2 off = AXIS / size * (tap_place(i, reach) / texel_mm);
    vec3 after = texture(source, middle_at + off).rgb, before = texture(source, middle_at - off).rgb;
    sum += tap_weight(i, reach) * ((after - middle) + (before - middle));
  }
  out_blurred = vec4(middle + sum, 1.0);
}
