// SPDX-License-Identifier: Apache-2.0
// Wrap lighting with a shift of colour where light turns to shade: Green, GPU Gems, 2004, chapter 16. `wrapped` is
// (N.L + wrap) / (1 + wrap), from 0. The bump rises up to `width` and is gone at twice that; the chapter's smoothstep from the
// larger to the smaller edge is undefined in GLSL.
vec3 with_shift(float wrapped, float width, vec3 shift) {
  return vec3(wrapped) + shift * (smoothstep(0.0, width, wrapped) * (1.0 - smoothstep(width, 2.0 * width, wrapped)));
}
