// SPDX-License-Identifier: Apache-2.0
// Light on the far side, weakened by a thickness map that an artist painted, and no map of the light: the quick way of deferred
// renderers for ears and hands.
#include "medium.glsl"
layout(binding = 5) uniform sampler2D translucent_thickness;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  vec3 passed = exp(-extinction() * (texture(translucent_thickness, in_uv).r * thickness_scale));
  return max(cosine, 0.0) + passed * wrapped_cosine(-cosine, wrap);
}
#include "through.glsl"
