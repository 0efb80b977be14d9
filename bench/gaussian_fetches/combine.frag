// SPDX-License-Identifier: Apache-2.0
// The look-ups of the six Gaussians' sum (shaders/skin/combine.frag), and nothing else.
layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D gaussian_2;
layout(binding = 6) uniform sampler2D gaussian_3;
layout(binding = 7) uniform sampler2D gaussian_4;
layout(binding = 8) uniform sampler2D gaussian_5;
layout(binding = 9) uniform sampler2D gaussian_6;
layout(location = 0) out vec4 out_sum;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  out_sum = texelFetch(light, texel, 0) + texelFetch(gaussian_2, texel, 0) + texelFetch(gaussian_3, texel, 0) +
            texelFetch(gaussian_4, texel, 0) + texelFetch(gaussian_5, texel, 0) + texelFetch(gaussian_6, texel, 0);
}
