// SPDX-License-Identifier: Apache-2.0
// A disc by one trilinear fetch, its mip level that of a disc of the same variance (footprints.glsl).

vec4 fetch_of(sampler2D source, vec2 center, Footprint footprint) {
  return textureGrad(source, center, footprint.uv_dx, footprint.uv_dy);
}

// The true disc: variance r^2 / 4 per axis. To be judged against the truth.
vec4 one_fetch_disc(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  return fetch_of(source, center, widened(source, radius, 1.0, footprint));
}

// What the 13 taps of poisson_disc.glsl are instead: their mean lies at (0.0281, -0.0966) r, their variance is 0.318 r^2 per axis,
// a disc of 1.128 r. To be judged against them.
vec4 one_fetch_thirteen(sampler2D source, vec2 center, vec2 radius, Footprint footprint) {
  return fetch_of(source, center + vec2(0.0281, -0.0966) * radius, widened(source, radius, 1.128, footprint));
}
