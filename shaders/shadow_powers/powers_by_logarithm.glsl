// SPDX-License-Identifier: Apache-2.0
// Red of Clement's sharpened shadow: the shadow to two powers, mixed by the amount of diffusion, with a quarter of the chroma
// left. A shadow below 0, as noise makes it, is 0.
#ifndef POWERS_BY_LOGARITHM_GLSL
#define POWERS_BY_LOGARITHM_GLSL
float powers_by_logarithm(float s, float px, float py, float amount) {
  vec2 sharp = s > 0.0 ? exp2(vec2(px, py) * log2(max(s, 1e-30))) : vec2(0.0);
  float red = mix(sharp.y, sharp.x, amount), rest = mix(sharp.y, sharp.x, 0.5 * amount);
  return clamp(mix(red, 0.30 * red + 0.70 * rest, 0.75), 0.0, 1.0);
}
#endif
