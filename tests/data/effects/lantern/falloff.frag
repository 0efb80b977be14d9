// SPDX-License-Identifier: Apache-2.0
// A table computed once: the square of the distance from the middle of the texel to the left edge, 0 to 1.
layout(location = 0) out vec4 out_value;

void main() {
  float x = gl_FragCoord.x / 64.0;
  out_value = vec4(x * x, 0.0, 0.0, 1.0);
}
