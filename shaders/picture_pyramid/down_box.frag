// SPDX-License-Identifier: Apache-2.0
// The mean of 2x2 texels.
#include "down.glsl"

void main() {
  out_color = textureLod(pyramid, middle(), 0.0);
  keep_nearest(0);
}
