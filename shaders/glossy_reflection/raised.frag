// SPDX-License-Identifier: Apache-2.0
// The mirror's picture from a pyramid that was blurred on its way up as far as each pixel wants.
#include "spread.glsl"

layout(binding = 5) uniform sampler2D pyramid;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  SeenFacets seen = seen_facets(at, to_eye);
  vec3 reflected = textureLod(pyramid, spread_of(at, to_eye, seen).uv, 0.0).rgb;
  out_color = vec4(light_of_surface(at, to_eye, reflected * middle_share(at, to_eye, seen)), 1.0);
}
