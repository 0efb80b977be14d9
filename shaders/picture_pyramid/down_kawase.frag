// SPDX-License-Identifier: Apache-2.0
// Dual filtering's way down: the middle four times and four diagonals. Bjørge, "Bandwidth-Efficient Rendering", SIGGRAPH 2015
// (course), after Kawase 2003.
#include "down.glsl"

void main() {
  vec2 texel = texel_size(), at = middle();
  out_color = (4.0 * textureLod(pyramid, at, 0.0) + textureLod(pyramid, at + texel * vec2(-1, -1), 0.0) +
               textureLod(pyramid, at + texel * vec2(1, -1), 0.0) + textureLod(pyramid, at + texel * vec2(-1, 1), 0.0) +
               textureLod(pyramid, at + texel * vec2(1, 1), 0.0)) / 8.0;
  keep_nearest(1);
}
