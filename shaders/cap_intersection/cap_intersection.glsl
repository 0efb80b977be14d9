// SPDX-License-Identifier: Apache-2.0
// The area that two spherical caps share, by the function that CAP_INTERSECTION names. Arguments out of range are settled here,
// before any function sees them: a radius of 0 or less, or NaN, is no cap; a radius beyond pi is the whole sphere; a distance
// outside [0, pi] becomes the nearer end; a distance of NaN shares nothing.
#include "cap.glsl"
#include "close_fit_cap.glsl"
#include "exact_cap.glsl"
#include "fast_acos_cap.glsl"
#include "fitted_cap.glsl"
#include "folded_fit_cap.glsl"
#include "linear_cap.glsl"
#ifdef CAP_TABLE_BINDING
#include "lut_cap.glsl"
#endif
#include "naive_cap.glsl"
#include "quick_fit_cap.glsl"
#include "smoothstep_cap.glsl"

// Angular radii and distance of the centres in radians; the area in steradians.
float cap_intersection(float r0, float r1, float d) {
  if (!(r0 > 0.0 && r1 > 0.0) || isnan(d)) return 0.0;
  return CAP_INTERSECTION(min(r0, pi), min(r1, pi), clamp(d, 0.0, pi));
}
