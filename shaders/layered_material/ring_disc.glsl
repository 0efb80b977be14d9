// SPDX-License-Identifier: Apache-2.0
// A disc by four taps on a ring of 0.6 r, each 0.6 r wide: the variance 0.6^2 / 2 + 0.6^2 / 4 = 0.27 r^2 per axis is near the disc's
// 0.25, and among rings of four these two numbers came out nearest to discs of marble, veins and pink noise. Their footprints close
// the gaps through which sparse sharp taps let fine detail alias.
// The mean is kept as the first tap plus mean differences: a constant comes back unchanged, to the bit.

vec4 ring_disc(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  Footprint wide = widened(source, radius, 0.6, footprint);
  vec2 reach = 0.6 * radius;
  vec4 first = fetch_of(source, center + vec2(reach.x, 0.0), wide), sum = vec4(0.0);
  sum += fetch_of(source, center + vec2(0.0, reach.y), wide) - first;
  sum += fetch_of(source, center - vec2(reach.x, 0.0), wide) - first;
  sum += fetch_of(source, center - vec2(0.0, reach.y), wide) - first;
  return first + sum / 4.0;
}
