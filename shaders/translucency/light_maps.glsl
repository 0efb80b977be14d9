// SPDX-License-Identifier: Apache-2.0
// Where light enters what each light that casts shines on. A medium that scatters nothing reads no map.
#ifndef ENTRY_MAPS_GLSL
#define ENTRY_MAPS_GLSL
#include "light_distance.glsl"

#ifndef SCATTERS
#undef CASTING_LIGHTS
#endif
#include "../common/light_maps.glsl"

LIGHT_MAPS(entry, 8)  // xyz = normal where light enters, or 0; w = how far it has come there, 1e30 where nothing is

// In texels.
vec2 map_place(int light, vec3 position) { return light_map_place(light, position) * float(entry_side()); }
float texel_width(int light, vec3 position) { return light_map_width(light, position) / float(entry_side()); }

bool in_map(ivec2 texel) { return texel == clamp(texel, ivec2(0), ivec2(entry_side() - 1)); }

#endif
