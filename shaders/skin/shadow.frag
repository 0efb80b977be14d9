// SPDX-License-Identifier: Apache-2.0
// How far light comes, in metres, for shadows.
#include "../translucency/light_map.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(location = 0) out float out_distance;

void main() { out_distance = light_distance(this_light(), in_position); }
