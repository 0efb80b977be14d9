// SPDX-License-Identifier: Apache-2.0
// Cards of hair over a head: narrow strips of quads that are combed from a parting over the crown and fall down behind.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Half axes of the head that hair lies on, in metres; its middle is the origin, the face looks along +z.
inline constexpr glm::vec3 hair_head_half_m{0.079f, 0.113f, 0.099f};
inline constexpr glm::vec2 hair_card_m{0.020f, 0.19f};  // a card's width and length in the mean

// How high the hairline is, from -1 (under the head) to 1, in a unit direction from the head's middle.
float hairline(glm::vec3 direction);

// `per_layer` cards in each of five layers, the one next to the skin first; 12 quads a card. v runs from root (0) to tip (1), u
// over one of the clumps of strand_texture.h. Cards share no vertices. Normals point away from the head, rounded over each
// card.
Mesh hair_card_mesh(uint32_t per_layer);

}  // namespace lamina
