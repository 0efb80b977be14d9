// SPDX-License-Identifier: Apache-2.0
// The six Gaussians by levels of the light map's mip chain. A texel of level l, filtered, spreads light by about 4^l / 4
// texels^2.
#include "profile_numbers.glsl"

layout(binding = 4) uniform sampler2D light_levels;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_light;

void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(light_levels, 0)), texel_mm = texelFetch(stretch, ivec2(gl_FragCoord.xy), 0).xy;
  float area = max(texel_mm.x * texel_mm.y, 1e-8);
  vec3 first = textureLod(light_levels, at, 0.0).rgb, sum = first;
  for (int i = 1; i < 6; ++i)
    sum += profile_weight(i) * (textureLod(light_levels, at, max(0.5 * log2(4.0 * profile_variance(i) / area), 0.0)).rgb - first);
  out_light = vec4(sum, 1.0);
}
