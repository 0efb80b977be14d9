// SPDX-License-Identifier: Apache-2.0
// On a sphere each Gaussian of the profile, along chords, is a spherical one of sharpness R^2 / v; Hill's fit of the irradiance
// under one (M. Pettineo, "SG Series", part 3, 2016) makes light of it without a map. Gaussians wider than 0.4 mm see the
// vertex normal, since they are wider than pores.
float gaussian_irradiance(float c, float sharpness) {
  float eml = exp(-sharpness), em2l = eml * eml, rl = 1.0 / sharpness;
  float scale = 1.0 + 2.0 * em2l - rl, bias = (eml - em2l) * rl - em2l;
  float x = sqrt(max(1.0 - scale, 1e-8)), x0 = 0.36 * c, x1 = x / 1.44, n = x0 + x1;
  return scale * (abs(x0) <= x1 ? n * n / x : max(c, 0.0)) + bias;
}
vec3 spherical_gaussians(SkinPoint point, vec3 to_light, float lit) {
  float bend = max(abs(in_curvature), 1e-4), fine = dot(point.normal, to_light), coarse = dot(point.smooth_normal, to_light);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 6; ++i) {
    float variance = profile_variance(i);
    sum += profile_weight(i) * gaussian_irradiance(variance > 0.16 ? coarse : fine, max(1.0 / (variance * bend * bend), 0.5));
  }
  return point.albedo * lit * max(sum, 0.0);
}
