// SPDX-License-Identifier: Apache-2.0
// Wrap lighting with its shift of colour, tabulated over N.L from -1 (the first texel's centre) to 1 (the last's).
#include "wrap_colour.glsl"

layout(constant_id = 0) const float table_wrap = 0.2588;
layout(constant_id = 1) const float shift_width = 0.3;
layout(constant_id = 2) const float shift_red = 0.15;
const int table_texels = 256;
layout(location = 0) out vec4 out_light;

void main() {
  float cosine = 2.0 * floor(gl_FragCoord.x) / float(table_texels - 1) - 1.0;
  float wrapped = max(cosine + table_wrap, 0.0) / (1.0 + table_wrap);
  out_light = vec4(with_shift(wrapped, shift_width, vec3(shift_red, 0.0, 0.0)), 1.0);
}
