// SPDX-License-Identifier: Apache-2.0
// Fills the light map and the stretch map beyond the charts' edges from the nearest texel that a chart covers, so that no tap
// reads background.
layout(binding = 4) uniform sampler2D lit;
layout(binding = 5) uniform sampler2D stretched;
layout(binding = 6) uniform sampler2D nearest_seed;
layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_stretch;

void main() {
  vec2 seed = texelFetch(nearest_seed, ivec2(gl_FragCoord.xy), 0).xy;
  ivec2 texel = ivec2(max(seed, vec2(0.0)));
  out_light = seed.x < 0.0 ? vec4(0.0) : texelFetch(lit, texel, 0);
  out_stretch = seed.x < 0.0 ? vec4(1.0) : texelFetch(stretched, texel, 0);
}
