// SPDX-License-Identifier: Apache-2.0
// The light map by Hable's thirteen taps, with stretch correction; weights are divided by their sums.
#include "hable_taps.glsl"

layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_light;

void main() {
  vec2 size = vec2(textureSize(light, 0)), at = gl_FragCoord.xy / size;
  vec2 uv_a_mm = 1.0 / (max(texelFetch(stretch, ivec2(gl_FragCoord.xy), 0).xy, vec2(1e-4)) * size);
  vec3 middle = texture(light, at).rgb, sum = vec3(0.0), weights = hable_weights[0];
  for (int i = 1; i < 13; ++i) {
    sum += hable_weights[i] * (texture(light, at + hable_places[i] * uv_a_mm).rgb - middle);
    weights += hable_weights[i];
  }
  out_light = vec4(middle + sum / weights, 1.0);
}
