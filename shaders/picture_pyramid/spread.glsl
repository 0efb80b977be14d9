// SPDX-License-Identifier: Apache-2.0
// How far rays that leave a surface spread on the picture: the standard deviation in pixels, of the two axes' geometric mean.
// Comes after landing.glsl.

struct Spread {
  vec2 uv;       // where the ray through the middle facet lands
  vec2 axes_px;  // standard deviations, of rays off to the right and up
  float px;      // their geometric mean
};

// `right`, `up`: through facets that are off by one standard deviation along each axis. `surface`: where they leave.
Spread spread_of_rays(LeavingRay middle, LeavingRay right, LeavingRay up, vec3 surface) {
  float own_depth = view_depth_of(surface), start = depth_at(own_place());
  vec2 uv = landing(middle, max(start, own_depth));
  float depth = max(depth_at(uv), own_depth);
  // Straight on where it would land before the surface. No branches: lavapipe 22.3 crashes on uniforms that are read in one.
  uv = mix(uv, own_place(), 1.0 - step(own_depth, depth_at(uv)));
  vec2 at = picture_at(middle, depth);
  vec2 axes = vec2(length((picture_at(right, depth) - at) * frame_size_px.xy),
                   length((picture_at(up, depth) - at) * frame_size_px.xy)) * (right.passes && up.passes ? 1.0 : 0.0);
  return Spread(uv, axes, sqrt(axes.x * axes.y));
}

// The level of a pyramid whose level l spreads by SPREAD * 2^l pixels, level 0 by none. Between two levels the mix has the mean
// of their variances.
float level_of(float px) {
  float variance = px * px, whole = floor(max(log2(max(px, 1e-6) / SPREAD), 0.0));
  float low = whole > 0.0 ? SPREAD * SPREAD * exp2(2.0 * whole) : 0.0, high = SPREAD * SPREAD * exp2(2.0 * whole + 2.0);
  return whole + clamp((variance - low) / (high - low), 0.0, 1.0);
}
