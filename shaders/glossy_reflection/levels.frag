// SPDX-License-Identifier: Apache-2.0
// The mirror's picture from a pyramid of it: where the middle facet's ray lands, as blurred as rays spread.
#include "spread.glsl"
#include "picture_pyramid/levels.glsl"

layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  SeenFacets seen = seen_facets(at, to_eye);
  Spread spread = spread_of(at, to_eye, seen);
#ifdef ROUGH
  vec3 reflected = from_levels(spread, view_depth_of(at.position));
#else
  vec3 reflected = textureLod(pyramid, spread.uv, 0.0).rgb;
#endif
  out_color = vec4(light_of_surface(at, to_eye, reflected * middle_share(at, to_eye, seen)), 1.0);
}
