// SPDX-License-Identifier: Apache-2.0
// The volume fog's sum in the light's view (James, "Real-Time Animated Translucency", GDC 2004): added up over all faces, how far
// the light has come at those it leaves through less those it enters through is the thickness of all that is solid.
#include "light_map.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(location = 0) out vec4 out_sum;

void main() {
  float come = light_distance(this_light(), in_position);
  out_sum = vec4(gl_FrontFacing ? -come : come, 0.0, 0.0, 0.0);
}
