// SPDX-License-Identifier: Apache-2.0
// Dual filtering's way up, as far as each pixel wants: four taps beside and four between them twice, blended over the level's own
// picture by how much of the coarser one is wanted there (alpha).
layout(binding = 4) uniform sampler2D pyramid;
layout(binding = 5) uniform sampler2D wanted;  // level, with mips
layout(location = 0) out vec4 out_color;
layout(std140, binding = 2) uniform Pass { ivec4 iteration; };

void main() {
  vec2 texel = 1.0 / vec2(textureSize(pyramid, 0)), at = gl_FragCoord.xy * 0.5 * texel;
  float level = float(iteration.y - 1 - iteration.x);  // the one that is written
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 side = i == 0 ? vec2(1, 0) : i == 1 ? vec2(-1, 0) : i == 2 ? vec2(0, 1) : vec2(0, -1);
    vec2 corner = i == 0 ? vec2(1, 1) : i == 1 ? vec2(-1, 1) : i == 2 ? vec2(1, -1) : vec2(-1, -1);
    sum += textureLod(pyramid, at + side * texel, 0.0) + 2.0 * textureLod(pyramid, at + 0.5 * corner * texel, 0.0);
  }
  float here = textureLod(wanted, gl_FragCoord.xy / vec2(textureSize(wanted, int(level))), level).r;
  out_color = vec4(sum.rgb / 12.0, clamp(here - level, 0.0, 1.0));
}
