// SPDX-License-Identifier: Apache-2.0
// Taps that carry a footprint: a mip level as wide as the part of the disc that one tap stands for.
//
// One trilinear fetch at level l has the variance 4^l / 4 texels^2 per axis (box 4^l / 12, tent between texels 4^l / 6 on average):
// that of a disc of radius 2^l. Derivatives of c r texels along both axes ask for the level log2(c r). The screen's own footprint is
// taken where it is wider, unchanged: radius 0 then returns, to the bit, what the plain fetch returns.
// Needs poisson_disc.glsl's Footprint.

// `radius` is in texture coordinates per axis, `share` the c above.
Footprint widened(sampler2D source, vec2 radius, float share, Footprint footprint) {
  vec2 size = vec2(textureSize(source, 0)), along = footprint.uv_dx * size, down = footprint.uv_dy * size, wide = share * radius * size;
  bool screen_is_wider = max(dot(along, along), dot(down, down)) >= max(wide.x * wide.x, wide.y * wide.y);
  return screen_is_wider ? footprint : Footprint(vec2(share * radius.x, 0.0), vec2(0.0, share * radius.y));
}
