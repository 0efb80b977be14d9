// SPDX-License-Identifier: Apache-2.0
// A missing pixel of a checkerboard beside a straight edge between 0 and 1, from its neighbours. The edge is x + slope y =
// offset, in pixels from the pixel's middle, 1 to its left; pixels hold the edge averaged over their squares.
#include "../transparency/reconstruction.glsl"

// The integral of clamp(t, 0, 1) up to t.
float ramp_integral(float t) { return t <= 0.0 ? 0.0 : t >= 1.0 ? t - 0.5 : 0.5 * t * t; }

// The share of the square around (x, y) that lies left of the edge.
float covered_share(float slope, float offset, vec2 pixel) {
  float left = offset - pixel.x - slope * pixel.y + 0.5;
  if (abs(slope) < 1e-3) return clamp(left, 0.0, 1.0);
  return (ramp_integral(left + 0.5 * slope) - ramp_integral(left - 0.5 * slope)) / slope;
}

vec4 held(float slope, float offset, vec2 pixel) { return vec4(vec3(covered_share(slope, offset, pixel)), 0.0); }

CrossValues cross_of(float slope, float offset) {
  CrossValues ends;
  const vec2 at[4] = vec2[](vec2(0, -1), vec2(0, 1), vec2(-1, 0), vec2(1, 0));
  for (int i = 0; i < 4; ++i) ends.value[i] = held(slope, offset, at[i]), ends.taken[i] = 1.0;
  return ends;
}

float mean_of_four_ends(float slope, float offset) {
  float taken;
  return mean_of_four(cross_of(slope, offset), taken).r;
}
float directed_pair(float slope, float offset) {
  float taken;
  return directed_pairs(cross_of(slope, offset), taken).r;
}
float twelve_neighbours(float slope, float offset) {
  float taken;
  vec4 knights = vec4(0.0);
  for (int i = 0; i < 8; ++i) {
    float x = (i & 1) == 0 ? -1.0 : 1.0, y = (i & 2) == 0 ? -1.0 : 1.0;
    knights += held(slope, offset, i < 4 ? vec2(x, 2.0 * y) : vec2(2.0 * x, y));
  }
  return twelve_taps(cross_of(slope, offset), knights, true, taken).r;
}
// Of one pixel in four, bilinear: the four corners of the 2x2 around, or two where the pixel lies between two.
float quad_corners(float slope, float offset) {
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += 0.25 * covered_share(slope, offset, vec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1));
  return sum;
}
// The pixel itself, which a checkerboard does not have.
float full_rate(float slope, float offset) { return covered_share(slope, offset, vec2(0.0)); }

// By the function that STEP_RECONSTRUCTION names.
#ifdef STEP_RECONSTRUCTION
float step_reconstruction(float slope, float offset) { return STEP_RECONSTRUCTION(slope, offset); }
#endif
