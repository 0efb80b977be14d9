// SPDX-License-Identifier: Apache-2.0
// Where light leaves: how far it has come at the last surface.
#include "light_map.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(location = 0) out vec4 out_leaving;

void main() { out_leaving = vec4(light_distance(this_light(), in_position), 0.0, 0.0, 1.0); }
