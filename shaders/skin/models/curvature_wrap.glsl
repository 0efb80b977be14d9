// SPDX-License-Identifier: Apache-2.0
// Light wrapped in each channel by what the profile calls for at this curvature: on a sphere the light at N.L = 0 is the mean
// width of the profile over R sqrt(2 pi), and a wrap w / (1 + w)^2, which keeps Lambert's energy, is that where w is about e (1
// + 2 e).
vec3 curvature_wrap(SkinPoint point, vec3 to_light, float lit) {
  vec3 width = vec3(0.0);
  for (int i = 0; i < 6; ++i) width += profile_weight(i) * sqrt(profile_variance(i));
  vec3 edge = min(width * max(in_curvature, 0.0) * 0.39894228, 0.2), w = edge * (1.0 + 2.0 * edge);
  return point.albedo * lit * max(dot(point.normal, to_light) + w, 0.0) / ((1.0 + w) * (1.0 + w));
}
