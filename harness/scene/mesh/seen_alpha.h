// SPDX-License-Identifier: Apache-2.0
// The greatest alpha of a texture wherever a mesh shows it, so that what nothing calls for can be left out.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The greatest alpha, 0 to 1, of all base-level texels of `texture` that bilinear filtering may read anywhere on the mesh's
// triangles: texels whose centre lies within one texel, along both axes, of a point of a triangle. Texels beyond the border
// count as the texture wraps, or where it does not say for clamp and repeat. Never too low; too high only where a triangle
// spans more than two tiles.
float seen_alpha(const Mesh& mesh, const TextureImage& texture);

// The same. Where it is 0, `texture` becomes a copy whose alpha is 0 everywhere, so that no unseen texel reaches the picture
// through the mip chain.
float settle_seen_alpha(const Mesh& mesh, Texture& texture);

}  // namespace lamina
