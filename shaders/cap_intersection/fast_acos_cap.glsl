// SPDX-License-Identifier: Apache-2.0
// As production engines do it: cosines in, arc cosine by sqrt(1 - |x|) times a polynomial of degree 1 (Eberly, "A Fast and
// Accurate Estimate for arccos", Geometric Tools, coefficients for degree 1), then the smoothstep. In binary32 the cosine of a
// small radius is 1: the radius is lost.
#include "cap.glsl"

float fast_acos(float x) {
  float y = abs(x);
  float angle = sqrt(1.0 - y) * (1.570796 - 0.1565827 * y);
  return x < 0.0 ? pi - angle : angle;
}

float fast_acos_cap(float r0, float r1, float d) {
  float c0 = cos(r0), c1 = cos(r1);
  float a0 = fast_acos(c0), a1 = fast_acos(c1), distance = fast_acos(cos(d));
  float t = clamp((a0 + a1 - distance) / max(2.0 * min(a0, a1), 1e-4), 0.0, 1.0);
  return 2.0 * pi * (1.0 - max(c0, c1)) * t * t * (3.0 - 2.0 * t);
}
