// SPDX-License-Identifier: Apache-2.0
// Opacity over optical thickness, 0 at the first texel's centre to TABLE_END at the last one's of TABLE_TEXELS.
layout(location = 0) out float out_opacity;

void main() {
  float part = (gl_FragCoord.x - 0.5) / (float(TABLE_TEXELS) - 1.0);
  out_opacity = 1.0 - exp(-part * float(TABLE_END));
}
