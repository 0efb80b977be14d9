// SPDX-License-Identifier: Apache-2.0
// The look-ups of one direction of one Gaussian (shaders/skin/blur.frag), and nothing else: seven between texels and one of the
// stretch. What is added keeps them from being left out.
layout(binding = 4) uniform sampler2D source;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_sum;

void main() {
  vec2 size = vec2(textureSize(source, 0)), middle_at = gl_FragCoord.xy / size, step_uv = AXIS * 1.4 / size;
  vec4 sum = texelFetch(stretch, ivec2(gl_FragCoord.xy), 0) + texture(source, middle_at);
  for (int i = 1; i <= 3; ++i) sum += texture(source, middle_at + float(i) * step_uv) + texture(source, middle_at - float(i) * step_uv);
  out_sum = sum;
}
