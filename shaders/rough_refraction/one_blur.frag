// SPDX-License-Identifier: Apache-2.0
// The seed's: the sharp picture and one blurred picture, mixed. The share is the wanted spread over the blurred picture's.
#include "spread.glsl"

layout(binding = 5) uniform sampler2D pyramid;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  Spread spread = spread_of(at, to_eye);
  vec3 behind = textureLod(pyramid, spread.uv, 0.0).rgb;
#ifdef ROUGH
  float blurred = min(float(LEVEL), float(textureQueryLevels(pyramid) - 1));
  behind = mix(behind, textureLod(pyramid, spread.uv, blurred).rgb, clamp(spread.px / (SPREAD * exp2(blurred)), 0.0, 1.0));
#endif
  out_color = vec4(light_of_glass(at, to_eye, behind), 1.0);
}
