// SPDX-License-Identifier: Apache-2.0
// Which level of the pyramid each pixel of the glass wants.
#include "spread.glsl"

layout(location = 0) out float out_level;

void main() {
  SurfacePoint at = surface_point();
#ifdef ROUGH
  out_level = level_of(spread_of(at, normalize(eye_world.xyz - at.position)).px);
#else
  out_level = 0.0;
#endif
}
