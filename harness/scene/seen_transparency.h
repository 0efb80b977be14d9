// SPDX-License-Identifier: Apache-2.0
// How transparent the outer layer is where the mesh shows it, so that an effect that nothing calls for can be left out.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The greatest alpha, 0 to 1, of all base-level texels of `outer_albedo` that bilinear filtering may read anywhere on the
// mesh's triangles: texels whose centre lies within one texel, along both axes, of a point of a triangle. Texels beyond the
// border count for both wrap modes. Never too low; too high only where a triangle spans more than two tiles.
float seen_transparency(const Mesh& mesh, const TextureImage& outer_albedo);

// Sets layers.max_transparency. Where that is 0, outer_albedo becomes a copy whose alpha is 0 everywhere, so that no unseen
// transparent texel reaches the picture through the mip chain.
void settle_transparency(LayeredMaterial& layers, const Mesh& mesh);

}  // namespace lamina
