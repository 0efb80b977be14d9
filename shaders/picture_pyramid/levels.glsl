// SPDX-License-Identifier: Apache-2.0
// The blurred picture from adjacent levels of a pyramid of it. Where the level holds something that is nearer than the surface, a
// finer one is taken, so that it does not bleed into what is seen there.
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
  for (int i = 0; i < 6; ++i) {
    bool holds_nearer = nearest_at(spread.uv, int(ceil(level))) < own_depth;
    level = holds_nearer ? max(ceil(level) - 1.0, 0.0) : level;
  }
  return textureLod(pyramid, spread.uv, level).rgb;
}
