// SPDX-License-Identifier: Apache-2.0
// How far rays through the slab spread on the picture: the standard deviation in pixels, of the two axes' geometric mean.
#include "slab.glsl"

struct Spread {
  vec2 uv;   // where the ray through the middle facet lands
  float px;  // standard deviation
};

Spread spread_of(SurfacePoint at, vec3 to_eye) {
  float own_depth = view_depth_of(at.position), start = depth_at(gl_FragCoord.xy * frame_size_px.zw);
  Through straight = through_slab(at, to_eye, vec2(0.0));
  vec2 uv = landing(straight, max(start, own_depth));
  float depth = max(depth_at(uv), own_depth), off = roughness * roughness * 0.70710678;
  // Straight on where it would land before the glass. No branches: lavapipe 22.3 crashes on uniforms that are read in one.
  uv = mix(uv, gl_FragCoord.xy * frame_size_px.zw, 1.0 - step(own_depth, depth_at(uv)));
  vec2 middle = picture_at(straight.from, straight.direction, depth);
  Through right = through_slab(at, to_eye, vec2(off, 0.0)), up = through_slab(at, to_eye, vec2(0.0, off));
  float across = length((picture_at(right.from, right.direction, depth) - middle) * frame_size_px.xy);
  float along = length((picture_at(up.from, up.direction, depth) - middle) * frame_size_px.xy);
  return Spread(uv, sqrt(across * along) * (right.passes && up.passes ? 1.0 : 0.0));
}

// The level of a pyramid whose level l spreads by SPREAD * 2^l pixels, level 0 by none. Between two levels the mix has the mean
// of their variances.
float level_of(float px) {
  float variance = px * px, whole = floor(max(log2(max(px, 1e-6) / SPREAD), 0.0));
  float low = whole > 0.0 ? SPREAD * SPREAD * exp2(2.0 * whole) : 0.0, high = SPREAD * SPREAD * exp2(2.0 * whole + 2.0);
  return whole + clamp((variance - low) / (high - low), 0.0, 1.0);
}
