// SPDX-License-Identifier: Apache-2.0
// The fragment stage's side of cards.vert, and the numbers of the effect.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(location = 4) in vec3 in_painted;
layout(location = 5) flat in float in_card;
layout(location = 6) flat in ivec2 in_lights;

layout(std140, binding = 3) uniform Effect {
  float gloss, gloss_strength, roughness_along, roughness_across, strength, shift, camera_light;
};
