// SPDX-License-Identifier: Apache-2.0
// What the outer layer lets through of the light that falls on it, texel by texel. Output: rgb irradiance.

layout(std140, binding = 3) uniform Effect { float shadowing; };
layout(binding = 4) uniform sampler2D light_map;  // alpha = the outer layer's transparency
layout(location = 0) out vec4 out_light;

void main() {
  vec4 light = texelFetch(light_map, ivec2(gl_FragCoord.xy), 0);
  out_light = vec4(light.rgb * mix(1.0, light.a, shadowing), 1.0);
}
