// SPDX-License-Identifier: Apache-2.0
// The picture behind the glass from a pyramid of it: where the ray through the middle facet lands, as blurred as rays spread.
// Between levels the two adjacent ones are mixed (trilinear). Where the level holds something that is nearer than the glass, a
// finer one is taken, so that it does not bleed into the glass.
#include "spread.glsl"

layout(binding = 5) uniform sampler2D pyramid;
layout(binding = 6) uniform sampler2D nearest;
layout(location = 0) out vec4 out_color;

// The nearest depth in the four texels that a linear look-up reads.
float nearest_at(vec2 uv, int level) {
  ivec2 size = textureSize(nearest, level), first = ivec2(floor(uv * vec2(size) - 0.5));
  float least = 1e30;
  for (int i = 0; i < 4; ++i) least = min(least, texelFetch(nearest, clamp(first + ivec2(i & 1, i >> 1), ivec2(0), size - 1), level).r);
  return least;
}

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  Spread spread = spread_of(at, to_eye);
  float level = 0.0;
#ifdef ROUGH
  level = min(level_of(spread.px), float(textureQueryLevels(pyramid) - 1));
  float own_depth = view_depth_of(at.position);
  // No branch around the look-up: see cone_samples.frag.
  for (int i = 0; i < 6; ++i) {
    bool holds_nearer = nearest_at(spread.uv, int(ceil(level))) < own_depth;
    level = holds_nearer ? max(ceil(level) - 1.0, 0.0) : level;
  }
#endif
  out_color = vec4(light_of_glass(at, to_eye, textureLod(pyramid, spread.uv, level).rgb), 1.0);
}
