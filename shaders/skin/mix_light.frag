// SPDX-License-Identifier: Apache-2.0
// Light of which KEPT, in each channel, stays where it is, and the rest is blurred.
#include "profile_numbers.glsl"

layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D blurred;
layout(location = 0) out vec4 out_light;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 first = texelFetch(light, texel, 0).rgb;
  out_light = vec4(first + (1.0 - KEPT) * (texelFetch(blurred, texel, 0).rgb - first), 1.0);
}
