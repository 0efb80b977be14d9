// SPDX-License-Identifier: Apache-2.0
// A point of the surface from the tile that the transform made, between texels.
#include "sea_tile.glsl"
layout(binding = 4) uniform sampler2D sea_shape;
layout(binding = 16) uniform sampler2D sea_slopes;

vec4 tiled_texel(sampler2D tile, vec2 texel) {
  ivec2 side = textureSize(tile, 0), low = ivec2(floor(texel));
  vec2 share = texel - floor(texel);
  ivec2 a = ((low % side) + side) % side, b = (a + 1) % side;
  return mix(mix(texelFetch(tile, a, 0), texelFetch(tile, ivec2(b.x, a.y), 0), share.x),
             mix(texelFetch(tile, ivec2(a.x, b.y), 0), texelFetch(tile, b, 0), share.x), share.y);
}

WavePoint sea_point(vec2 ground) {
  // Texel i lies at i of the side, not at its middle.
  vec2 texel = fract(ground / sea_tile_m()) * vec2(textureSize(sea_shape, 0));
  vec4 shape = tiled_texel(sea_shape, texel), slopes = tiled_texel(sea_slopes, texel);
  return WavePoint(vec3(shape.y, shape.x, shape.z), vec3(slopes.z, slopes.x, shape.w), vec3(shape.w, slopes.y, slopes.w));
}
