// SPDX-License-Identifier: Apache-2.0
// fitted_cap for all radii. A cap larger than a hemisphere is replaced by its complement, a smaller cap around the opposite
// point, and the result is subtracted. So no cap of the fit is larger than a hemisphere, and the error stays the same share of
// the smaller cap.
#include "cap.glsl"
#include "fitted_cap.glsl"

float folded_fit_cap(float r0, float r1, float d) {
  bool over0 = r0 > 0.5 * pi, over1 = r1 > 0.5 * pi;
  float folded0 = over0 ? max(pi - r0, 1e-18) : r0, folded1 = over1 ? max(pi - r1, 1e-18) : r1;
  float in_both = fitted_cap(folded0, folded1, over0 != over1 ? pi - d : d);
  float area0 = cap_area_polynomial(folded0 * folded0), area1 = cap_area_polynomial(folded1 * folded1);
  if (over0 && over1) return 4.0 * pi - area0 - area1 + in_both;
  return over0 ? area1 - in_both : over1 ? area0 - in_both : in_both;
}
