// SPDX-License-Identifier: Apache-2.0
// The sharp picture behind the glass and one blurred picture, mixed.
#include "spread.glsl"
#include "picture_pyramid/one_blur.glsl"

layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  Spread spread = spread_of(at, to_eye);
#ifdef ROUGH
  vec3 behind = from_one_blur(spread);
#else
  vec3 behind = textureLod(pyramid, spread.uv, 0.0).rgb;
#endif
  out_color = vec4(light_of_glass(at, to_eye, behind), 1.0);
}
