// SPDX-License-Identifier: Apache-2.0
// One direction of a separable blur that is another one in each channel: taps lie closer near the middle, as in Jimenez's
// separable kernel, and weigh what the profile's line of light holds between the middles of the gaps beside them. All channels
// share the taps. Definition HALF_TAPS: taps on each side. CHANNEL_BLUR names the line of light.
#ifndef CHANNEL_TAPS_GLSL
#define CHANNEL_TAPS_GLSL
#include "profile_numbers.glsl"

// Abramowitz and Stegun 7.1.26: within 1.5e-7.
float error_function(float x) {
  float a = abs(x), t = 1.0 / (1.0 + 0.3275911 * a);
  float tail = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) * exp(-a * a);
  return x < 0.0 ? tail - 1.0 : 1.0 - tail;
}
vec3 error_functions(vec3 x) { return vec3(error_function(x.x), error_function(x.y), error_function(x.z)); }

// Lines of light integrated from 0 to x millimetres, and how far they reach.
// One Gaussian a channel, the best for an edge of light; the profile's own widths scale it.
vec3 profile_scale() { return sqrt(mean_variance() / vec3(1.38287, 0.06813, 0.02477)); }
vec3 line_one(float x) { return 0.5 * error_functions(x / (1.41421356 * vec3(0.612, 0.174, 0.122) * profile_scale())); }
// The wider of two Gaussians a channel; the narrower is below a texel.
vec3 line_wide(float x) { return 0.5 * error_functions(x / (1.41421356 * sqrt(vec3(1.607, 0.1129, 0.0425)) * profile_scale())); }
// All Gaussians but the narrowest, whose light stays where it is.
vec3 line_rest(float x) {
  vec3 sum = vec3(0.0);
  for (int i = 1; i < 6; ++i) sum += profile_weight(i) * (0.5 * error_function(x / (1.41421356 * sqrt(profile_variance(i)))));
  return sum / max(1.0 - profile_weight(0), 1e-3);
}
float reach_one() { return 2.5 * 0.612 * profile_scale().r; }
float reach_wide() { return 2.5 * 1.2677 * profile_scale().r; }
float reach_rest() { return 2.5 * sigma_6; }

// Millimetres of tap i from the middle.
float tap_place(int i, float reach) {
  float share = float(i) / float(HALF_TAPS);
  return reach * share * share;
}
vec3 tap_weight(int i, float reach) {
  float here = tap_place(i, reach), inner = 0.5 * (here + tap_place(i - 1, reach)),
        outer = i == HALF_TAPS ? 1e3 * reach : 0.5 * (here + tap_place(i + 1, reach));
  return LINE(outer) - LINE(inner);
}

#endif
