// SPDX-License-Identifier: Apache-2.0
// A disc by 13 taps on Vogel's spiral: tap i at radius sqrt((i + 1/2) / 13) and angle i times the golden angle.
// Source: Helmut Vogel, "A better way to construct the sunflower head", Mathematical Biosciences 44 (1979).
// As many fetches as poisson_disc.glsl, but evenly spread, and centred to 0.03 r.

const int golden_taps = 13;
const float golden_angle = 2.39996323;

vec4 golden_disc(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  vec4 first = vec4(0.0), sum = vec4(0.0);
  for (int i = 0; i < golden_taps; ++i) {
    float angle = float(i) * golden_angle, distance = sqrt((float(i) + 0.5) / float(golden_taps));
    vec4 tap = fetch_of(source, center + vec2(cos(angle), sin(angle)) * distance * radius, footprint);
    if (i == 0) first = tap;
    sum += tap - first;
  }
  return first + sum / float(golden_taps);
}
