// SPDX-License-Identifier: Apache-2.0
// Lengths on a surface in texels of its texture.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// Texels of `texture`'s base level for a length in the mesh's own units, by the mesh's mean texel density: sqrt(area in texels
// / area of the surface). Throws Error(bad_input) about `subject` where the mesh has no area in its texture.
float length_in_texels(float length, const Mesh& mesh, const TextureImage& texture, const std::string& subject);

}  // namespace lamina
