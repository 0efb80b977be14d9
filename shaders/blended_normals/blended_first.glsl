// SPDX-License-Identifier: Apache-2.0
// Saturated before the mix rather than after it: bumps that face away no longer darken the mean.
float blended_first(float vertex, float bump, float red, float rest) {
  float v = clamp(vertex, 0.0, 1.0), b = clamp(bump, 0.0, 1.0);
  return min(mix(b, v, red), mix(b, v, rest));
}
