// SPDX-License-Identifier: Apache-2.0
// The resizable Poisson disc of 13 taps. Source: Chris Oat, "Rendering Gooney Materials with Multiple Layers", SIGGRAPH 2006
// course, chapter 4, listing 2 (tap locations, centre included, equal weights).
//
// The average is kept as the centre plus the mean difference from it: the same number in exact arithmetic, and in floating point
// a constant texture comes back unchanged for every radius and radius 0 returns the centre tap to the bit.

const vec2 disc_taps[12] = vec2[12](
    vec2(-0.326212, -0.40581), vec2(-0.840144, -0.07358), vec2(-0.695914, 0.457137), vec2(-0.203345, 0.620716),
    vec2(0.96234, -0.194983), vec2(0.473434, -0.480026), vec2(0.519456, 0.767022), vec2(0.185461, -0.893124),
    vec2(0.507431, 0.064425), vec2(0.89642, 0.412458), vec2(-0.32194, -0.932615), vec2(-0.791559, -0.59771));

// uv_dx, uv_dy: screen derivatives of the surface's own texture coordinate. They choose the mip level of every tap, because those of
// the offset coordinate jump from pixel to pixel with the normal map.
struct Footprint {
  vec2 uv_dx, uv_dy;
};

// Mean of rgba over the disc around `center`; `radius` is in texture coordinates per axis.
vec4 poisson_disc(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  vec4 middle = textureGrad(source, center, footprint.uv_dx, footprint.uv_dy);
  vec4 difference = vec4(0.0);
  for (int i = 0; i < 12; ++i)
    difference += textureGrad(source, center + disc_taps[i] * radius, footprint.uv_dx, footprint.uv_dy) - middle;
  return middle + difference / 13.0;
}
