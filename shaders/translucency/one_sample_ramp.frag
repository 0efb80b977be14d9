// SPDX-License-Identifier: Apache-2.0
// One depth sample, and a ramp that an artist made: Green, "Real-Time Animated Translucency", GDC 2004. An object without a ramp
// has the exponential.
#include "medium.glsl"
#include "light_maps.glsl"
#include "one_path.glsl"
layout(binding = 5) uniform sampler2D translucent_ramp;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  if (lit.map < 0) return vec3(max(cosine, 0.0));
  float path = one_path(i, lit, normal, vec2(0.0)), texels = float(textureSize(translucent_ramp, 0).x);
  // The ends of the ramp are the centres of its first and last texels.
  float place = (min(path / ramp_length, 1.0) * (texels - 1.0) + 0.5) / texels;
  vec3 passed = texels > 1.0 ? textureLod(translucent_ramp, vec2(place, 0.5), 0.0).rgb : exp(-extinction() * path);
  return passed * both_sides(cosine);
}
#include "through.glsl"
