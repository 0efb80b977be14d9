// SPDX-License-Identifier: Apache-2.0
// What clip_from_view says of depth. Include after common/frame.glsl with clip_from_view.

// Metres of view depth of the near and the far plane.
vec2 clip_planes() {
  float scale = clip_from_view[2][2], shift = clip_from_view[3][2];
  return vec2(shift / scale, shift / (scale + 1.0));
}

// Metres of view depth of a depth in the depth buffer.
float view_depth_of(float window) { return clip_from_view[3][2] / (window + clip_from_view[2][2]); }
