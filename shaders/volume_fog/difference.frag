// SPDX-License-Identifier: Apache-2.0
// What adds less what takes away, channel by channel. 8 bits a channel hold no sign, so half of their range, 128, stands for 0:
// differences of more than 127 are cut.
layout(binding = 4) uniform sampler2D added_codes;
layout(binding = 5) uniform sampler2D taken_codes;
layout(location = 0) out vec4 out_difference;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 difference = texelFetch(added_codes, pixel, 0).rgb - texelFetch(taken_codes, pixel, 0).rgb;
  out_difference = vec4(difference + 128.0 / 255.0, 0.0);
}
