// SPDX-License-Identifier: Apache-2.0
// The inner layer's disc around each texel, once for a scene, at one of the radii that blurred_base.glsl mixes. Output: linear rgb,
// which the target encodes, and transparency.
#include "poisson_disc.glsl"

layout(std140, binding = 3) uniform Effect { float thickness; };
layout(binding = 4) uniform sampler2D inner_albedo;
layout(location = 0) out vec4 out_base;

const vec4 blurred_at = vec4(BLURRED_AT);

void main() {
  vec2 texel = 1.0 / vec2(textureSize(inner_albedo, 0));
  Footprint base_level = Footprint(vec2(texel.x, 0.0), vec2(0.0, texel.y));
  out_base = poisson_disc(inner_albedo, gl_FragCoord.xy * texel, blurred_at[PLACE] * thickness * texel, base_level);
}
