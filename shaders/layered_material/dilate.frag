// SPDX-License-Identifier: Apache-2.0
// Fills the light map beyond the charts' edges: every texel takes the light of the nearest texel that a chart covers, so that no
// tap, however far it is offset, reads background. A mesh without any covered texel leaves black.

layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D nearest_seed;
layout(location = 0) out vec4 out_light;

void main() {
  vec2 seed = texelFetch(nearest_seed, ivec2(gl_FragCoord.xy), 0).xy;
  out_light = seed.x < 0.0 ? vec4(0.0) : texelFetch(light, ivec2(seed), 0);
}
