// SPDX-License-Identifier: Apache-2.0
// The map's texel as the plane that was drawn there: its depth where the point lies. s: true path; slope: tangent of the angle
// between the entry's normal and the light; u: place of the point, from the texel's middle. All lengths in texels.
float plane(float s, float slope, float u) {
  precise float texel = s + slope * u;         // the point's depth less the texel's, as the map gives it
  return max(texel - slope * u, 0.0);  // corrected by the slope and place that the shader knows
}
