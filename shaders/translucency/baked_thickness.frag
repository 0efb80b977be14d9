// SPDX-License-Identifier: Apache-2.0
// Light on the far side, weakened by a thickness that rays have found below each point: it knows holes, and no light.
#include "medium.glsl"
#ifdef THICKNESS_MAP
layout(binding = 5) uniform sampler2D baked_thickness;
#else
layout(location = 4) in float in_thickness;
#endif

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
#ifdef THICKNESS_MAP
  float thickness = texture(baked_thickness, in_uv).r;
#else
  float thickness = in_thickness;
#endif
  return max(cosine, 0.0) + exp(-extinction() * thickness) * wrapped_cosine(-cosine, wrap);
}
#include "through.glsl"
