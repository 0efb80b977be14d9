// SPDX-License-Identifier: Apache-2.0
// The second pass: over the light of the first, the highlight along strands of just those cards that it left.
#include "cards_in.glsl"
#include "lighting.glsl"
#include "strand.glsl"
#include "highlight.glsl"

layout(location = 0) out vec4 out_color;  // added

void main() {
  SurfacePoint at = surface_point();
  out_color = vec4(strand_highlight(at, DIRECTION(at), normalize(eye_world.xyz - at.position), in_lights), 0.0);
}
