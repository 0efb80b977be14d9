// SPDX-License-Identifier: Apache-2.0
// What a mesh of cards says about strands: which triangles make a card, and which way strands run at its vertices.
#pragma once

#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct Strands {
  size_t cards = 0;
  std::vector<uint32_t> card_of;      // by vertex: parts of the mesh that share vertices, in the order in which they come
  std::vector<glm::vec3> directions;  // by vertex: unit dP/dv in object space, the mean of its triangles weighed by area
  glm::vec3 middle{0};                // of the box around the mesh, in object space
};

// Throws Error(bad_input) about `owner` where a card's texture coordinates give no direction.
Strands strands_of(const Mesh& mesh, const std::string& owner);

}  // namespace lamina
