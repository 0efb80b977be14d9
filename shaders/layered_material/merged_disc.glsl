// SPDX-License-Identifier: Apache-2.0
// The 13 taps of poisson_disc.glsl by five: clusters of two and three neighbours (k-means), each fetched once at its middle with a
// footprint as wide as the cluster. Imitates those 13 taps, with their shift and their gaps, not the disc.

const vec2 merged_middle[5] = vec2[5](vec2(-0.068, -0.913), vec2(0.648, -0.204), vec2(-0.300, 0.359), vec2(0.708, 0.590),
                                      vec2(-0.653, -0.359));
const float merged_taps[5] = float[5](2.0, 3.0, 3.0, 2.0, 3.0);
const float merged_width[5] = float[5](0.36, 0.445, 0.556, 0.366, 0.448);

vec4 merged_disc(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  vec4 first = vec4(0.0), sum = vec4(0.0);
  for (int i = 0; i < 5; ++i) {
    vec4 tap = fetch_of(source, center + merged_middle[i] * radius, widened(source, radius, merged_width[i], footprint));
    if (i == 0) first = tap;
    sum += merged_taps[i] * (tap - first);
  }
  return first + sum / 13.0;
}
