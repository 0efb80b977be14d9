// SPDX-License-Identifier: Apache-2.0
// Vertex colours as a part of the base colour's texture, which everything reads that draws or traces the object: passes, truths
// and bakers alike.
#pragma once

#include <span>
#include <string>

#include "harness/scene/model_look.h"
#include "harness/scene/scene.h"

namespace lamina {

// Multiplies the look's base colour by the colours (linear, one a vertex, linear between them over a triangle; glTF 2.0,
// section 3.7.2.1); their alpha counts where `alpha` says so. Equal colours multiply the texels. Else they are drawn over the
// mesh's texture coordinates where these use no texel twice; a look without pictures (`textured` false) gets a texture in which
// every triangle has a patch of its own, and the mesh texture coordinates into it. Otherwise nothing is changed, and the reason
// returned; "" where the colours are applied. Throws Error(failed) where there is not one colour a vertex.
std::string apply_vertex_colours(Mesh& mesh, std::span<const glm::vec4> colours, bool textured, bool alpha, ModelLook& look);

}  // namespace lamina
