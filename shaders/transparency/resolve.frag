// SPDX-License-Identifier: Apache-2.0
// The mean colour of all layers, by the opacity of all, for blending over the frame: premultiplied. The opacity is COVERING's
// product, or 1 - exp(-absorbance).
layout(binding = 4) uniform sampler2D sums;
#ifdef COVERING
layout(binding = 5) uniform sampler2D covering;
#else
layout(binding = 5) uniform sampler2D absorbance;
#endif
layout(location = 0) out vec4 out_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(sums, pixel, 0);
#ifdef COVERING
  float opacity = texelFetch(covering, pixel, 0).r;
#else
  float opacity = 1.0 - exp(-texelFetch(absorbance, pixel, 0).r);
#endif
  if (sum.a == 0.0) discard;
  out_color = vec4(sum.rgb / sum.a * opacity, opacity);
}
