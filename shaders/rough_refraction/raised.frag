// SPDX-License-Identifier: Apache-2.0
// The picture behind the glass from a pyramid that was blurred on its way up as far as each pixel wants.
#include "spread.glsl"

layout(binding = 5) uniform sampler2D pyramid;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  out_color = vec4(light_of_glass(at, to_eye, textureLod(pyramid, spread_of(at, to_eye).uv, 0.0).rgb), 1.0);
}
