// SPDX-License-Identifier: Apache-2.0
// The first pass: what is left of the cards goes into a geometry buffer and the depth buffer, like anything opaque.
#include "cards_in.glsl"
#include "kill.glsl"

layout(location = 0) out vec4 out_shape;   // world normal; the highlight's power, 0 where there is no hair
layout(location = 1) out vec4 out_colour;  // linear albedo; the highlight's strength

void main() {
  vec4 texel = texture(OPACITY, in_uv);
  if (killed(texel.a, ivec2(gl_FragCoord.xy), in_card, in_position)) discard;
  out_shape = vec4(normalize(in_normal), gloss);
  out_colour = vec4(texel.rgb, gloss_strength);
}
