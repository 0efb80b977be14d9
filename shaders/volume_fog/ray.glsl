// SPDX-License-Identifier: Apache-2.0
// Metres along a pixel's ray for a metre of view depth: |ray| / ray.z, 1 in the middle of the picture. Include after
// common/frame.glsl with clip_from_view in FRAME_MEMBERS.

float ray_length_per_depth() {
  vec2 clip = gl_FragCoord.xy * frame_size_px.zw * 2.0 - 1.0;
  vec2 slope = clip / vec2(clip_from_view[0][0], clip_from_view[1][1]);
  return sqrt(1.0 + dot(slope, slope));
}
