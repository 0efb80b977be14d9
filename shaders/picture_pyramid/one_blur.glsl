// SPDX-License-Identifier: Apache-2.0
// The seed's: the sharp picture and one blurred picture, mixed. The share is the wanted spread over the blurred picture's.
layout(binding = 5) uniform sampler2D pyramid;

vec3 from_one_blur(Spread spread) {
  float blurred = min(float(LEVEL), float(textureQueryLevels(pyramid) - 1));
  return mix(textureLod(pyramid, spread.uv, 0.0).rgb, textureLod(pyramid, spread.uv, blurred).rgb,
             clamp(spread.px / (SPREAD * exp2(blurred)), 0.0, 1.0));
}
