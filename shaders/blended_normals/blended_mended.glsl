// SPDX-License-Identifier: Apache-2.0
// Clement's blended N.L of the channels that are not red, mended: red sees the vertex normal most, and what is not red never
// more than red.
#ifndef BLENDED_MENDED_GLSL
#define BLENDED_MENDED_GLSL
float blended_red(float vertex, float bump, float red) { return clamp(mix(bump, vertex, red), 0.0, 1.0); }
float blended_mended(float vertex, float bump, float red, float rest) {
  return clamp(min(mix(bump, vertex, red), mix(bump, vertex, rest)), 0.0, 1.0);
}
#endif
