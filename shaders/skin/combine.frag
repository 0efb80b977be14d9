// SPDX-License-Identifier: Apache-2.0
// The sum of the six Gaussians by the profile's weights. The narrowest is the light map itself: it is narrower than texels are.
// The sum is the unblurred light and weighted differences from it, so that a constant comes back unchanged.
#include "profile_numbers.glsl"

layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D gaussian_2;
layout(binding = 6) uniform sampler2D gaussian_3;
layout(binding = 7) uniform sampler2D gaussian_4;
layout(binding = 8) uniform sampler2D gaussian_5;
layout(binding = 9) uniform sampler2D gaussian_6;
layout(location = 0) out vec4 out_light;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 first = texelFetch(light, texel, 0).rgb;
  out_light = vec4(first + profile_weight(1) * (texelFetch(gaussian_2, texel, 0).rgb - first) +
                       profile_weight(2) * (texelFetch(gaussian_3, texel, 0).rgb - first) +
                       profile_weight(3) * (texelFetch(gaussian_4, texel, 0).rgb - first) +
                       profile_weight(4) * (texelFetch(gaussian_5, texel, 0).rgb - first) +
                       profile_weight(5) * (texelFetch(gaussian_6, texel, 0).rgb - first),
                   1.0);
}
