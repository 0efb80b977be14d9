// SPDX-License-Identifier: Apache-2.0
// Layers that were put together already, for blending over the frame: premultiplied.
layout(binding = 4) uniform sampler2D layers;
layout(location = 0) out vec4 out_color;

void main() {
  out_color = texelFetch(layers, ivec2(gl_FragCoord.xy), 0);
  if (out_color.a == 0.0) discard;
}
