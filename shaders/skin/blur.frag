// SPDX-License-Identifier: Apache-2.0
// One direction of one Gaussian: AXIS is vec2(1, 0) or vec2(0, 1). Blurs are a chain: BLUR is the number of the Gaussian that
// this one makes, from 1, of the one before it. Stretch makes a blur as wide on the surface wherever it is (d'Eon and Luebke,
// listing 14-4). The sum is the middle tap and mean differences from it, so that a constant comes back unchanged.
#include "profile_numbers.glsl"
#include "gaussian_taps.glsl"

layout(binding = 4) uniform sampler2D source;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_blurred;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec2 size = vec2(textureSize(source, 0)), middle_at = gl_FragCoord.xy / size;
  float texel_mm = max(dot(texelFetch(stretch, texel, 0).xy, AXIS), 1e-4);
  float variance = max(profile_variance(BLUR) - profile_variance(BLUR - 1), 0.0);
  vec2 step_uv = AXIS * tap_spacing(variance / (texel_mm * texel_mm)) / size;
  vec4 middle = texture(source, middle_at), sum = vec4(0.0);
  for (int i = 1; i <= 3; ++i)
    sum += tap_weights[i - 1] * ((texture(source, middle_at + float(i) * step_uv) - middle) +
                                 (texture(source, middle_at - float(i) * step_uv) - middle));
  out_blurred = middle + sum;
}
