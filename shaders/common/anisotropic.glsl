// SPDX-License-Identifier: Apache-2.0
// A texture over a pixel that is long on it: as many trilinear looks along its longer side as that is longer, 8 at most, each as wide as
// the shorter side. One look alone is as wide as the longer side all around, and blurs what is seen at a slant. A level is filtered
// linearly between its texels too: a look is as blurred as a box that is wider than them by the root of 3.
vec4 anisotropic_texture(sampler2D source, vec2 uv) {
  vec2 size = vec2(textureSize(source, 0)), right = dFdx(uv), down = dFdy(uv);
  float right_texels = length(right * size), down_texels = length(down * size);
  vec2 longer = right_texels > down_texels ? right : down;
  float longest = max(right_texels, down_texels), shortest = min(right_texels, down_texels);
  int looks = int(clamp(ceil(longest / max(shortest, 1.0)), 1.0, 8.0));
  float level = log2(max(0.57735 * longest / float(looks), 1.0));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < looks; ++i) sum += textureLod(source, uv + longer * ((float(i) + 0.5) / float(looks) - 0.5), level);
  return sum / float(looks);
}
