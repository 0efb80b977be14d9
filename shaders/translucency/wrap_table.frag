// SPDX-License-Identifier: Apache-2.0
// Wrap lighting read from a table (Green, GPU Gems, 2004, chapter 16).
#include "medium.glsl"
layout(binding = 5) uniform sampler2D wrap_light;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  float texels = float(textureSize(wrap_light, 0).x);
  return textureLod(wrap_light, vec2(((0.5 + 0.5 * cosine) * (texels - 1.0) + 0.5) / texels, 0.5), 0.0).rgb;
}
#include "through.glsl"
