// SPDX-License-Identifier: Apache-2.0
// Which level of the pyramid each pixel of the surface wants.
#include "spread.glsl"

layout(location = 0) out float out_level;

void main() {
  SurfacePoint at = surface_point();
  out_level = 0.0;
#ifdef ROUGH
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  out_level = level_of(spread_of(at, to_eye, seen_facets(at, to_eye)).px);
#endif
}
