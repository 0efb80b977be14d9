// SPDX-License-Identifier: Apache-2.0
// The blurred picture from adjacent levels of a pyramid of it. Where the level holds something that is nearer than the surface, a
// finer one is taken, so that it does not bleed into what is seen there; of the finest the one texel that the place is in.
layout(binding = 5) uniform sampler2D pyramid;
layout(binding = 6) uniform sampler2D nearest;

// The nearest depth in the four texels that a linear look-up reads.
float nearest_at(vec2 uv, int level) {
  ivec2 size = textureSize(nearest, level), first = ivec2(floor(uv * vec2(size) - 0.5));
  float least = 1e30;
  for (int i = 0; i < 4; ++i) least = min(least, texelFetch(nearest, clamp(first + ivec2(i & 1, i >> 1), ivec2(0), size - 1), level).r);
  return least;
}

vec3 from_levels(Spread spread, float own_depth) {
  float level = min(level_of(spread.px), float(textureQueryLevels(pyramid) - 1));
  // No branch around the look-up: lavapipe 22.3 crashes on uniforms that are read in one.
  bool holds_nearer = false;
  for (int i = 0; i < 6; ++i) {
    holds_nearer = nearest_at(spread.uv, int(ceil(level))) < own_depth;
    level = holds_nearer ? max(ceil(level) - 1.0, 0.0) : level;
  }
  vec2 size = vec2(textureSize(pyramid, 0)), texel = (floor(spread.uv * size) + 0.5) / size;
  return textureLod(pyramid, mix(spread.uv, texel, holds_nearer ? 1.0 : 0.0), level).rgb;
}
