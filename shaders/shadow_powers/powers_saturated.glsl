// SPDX-License-Identifier: Apache-2.0
// Without the desaturation: the whole chroma.
float powers_saturated(float s, float px, float py, float amount) {
  vec2 sharp = exp2(vec2(px, py) * log2(max(s, 1e-30)));
  return clamp(mix(sharp.y, sharp.x, amount), 0.0, 1.0);
}
