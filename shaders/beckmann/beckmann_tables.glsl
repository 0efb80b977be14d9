// SPDX-License-Identifier: Apache-2.0
// 0.5 PH^0.1 over N.H and the slope (harness/effects/skin/beckmann_tables.h), read at the value's own texel.
layout(binding = BECKMANN_UNORM8_BINDING) uniform sampler2D beckmann_unorm8;  // linear filter, clamped
layout(binding = BECKMANN_UNORM16_BINDING) uniform sampler2D beckmann_unorm16;
layout(binding = BECKMANN_HALF_BINDING) uniform sampler2D beckmann_half;
layout(binding = BECKMANN_CENTRES_BINDING) uniform sampler2D beckmann_centres;

float tenth_power(float stored) {
  float root = 2.0 * stored, squared = root * root, fourth = squared * squared;
  return fourth * fourth * squared;
}
vec2 table_place(float nh, float m) { return (vec2(nh, m) * 255.0 + 0.5) / 256.0; }

float beckmann_table_unorm8(float nh, float m) { return tenth_power(textureLod(beckmann_unorm8, table_place(nh, m), 0.0).r); }
float beckmann_table_unorm16(float nh, float m) { return tenth_power(textureLod(beckmann_unorm16, table_place(nh, m), 0.0).r); }
float beckmann_table_half(float nh, float m) { return tenth_power(textureLod(beckmann_half, table_place(nh, m), 0.0).r); }
// As printed: texels hold the values at their centres, half floats here, and the coordinate is the value.
float beckmann_table_printed(float nh, float m) { return tenth_power(textureLod(beckmann_centres, vec2(nh, m), 0.0).r); }
