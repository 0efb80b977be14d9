// SPDX-License-Identifier: Apache-2.0
// 13 taps: five overlapping boxes of 4x4 texels, the one in the middle weighs half. Jimenez, "Next Generation Post Processing in
// Call of Duty: Advanced Warfare", SIGGRAPH 2014.
#include "down.glsl"

vec4 tap(float x, float y) { return textureLod(pyramid, middle() + vec2(x, y) * texel_size(), 0.0); }

void main() {
  vec4 inner = tap(-1.0, -1.0) + tap(1.0, -1.0) + tap(-1.0, 1.0) + tap(1.0, 1.0), centre = tap(0.0, 0.0);
  vec4 edges = tap(0.0, -2.0) + tap(-2.0, 0.0) + tap(2.0, 0.0) + tap(0.0, 2.0);
  vec4 corners = tap(-2.0, -2.0) + tap(2.0, -2.0) + tap(-2.0, 2.0) + tap(2.0, 2.0);
  out_color = 0.125 * (inner + centre) + 0.0625 * edges + 0.03125 * corners;
  keep_nearest(2);
}
