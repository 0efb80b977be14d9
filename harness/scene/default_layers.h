// SPDX-License-Identifier: Apache-2.0
// The layered material that a model gets where it, or its scene file, says nothing else.
#pragma once

#include <memory>
#include <string>

#include "harness/scene/scene.h"
#include "harness/scene/textures.h"

namespace lamina {

// Transparency of an outer layer that has none of its own: the inner layer shows clearly, the outer one still rules.
inline constexpr float default_transparency = 0.55f;

// Outer layer as given, transparency in `outer`'s alpha; a flat normal map where `normal` is null; an inner layer of the
// outer's size (at least 512, at most 1024 texels on a side), which all materials of that size share; thickness a hundredth of
// the inner layer's width; max_transparency not yet settled.
LayeredMaterial default_layers(const std::string& name, const Texels& outer, std::shared_ptr<const TextureImage> normal);

// Thickness in texels of `texture`'s base level for a thickness in the mesh's own units, by the mesh's mean texel density:
// sqrt(area in texels / area of the surface). Throws Error(bad_input) about `subject` where the mesh has no area in its
// texture.
float thickness_in_texels(float thickness, const Mesh& mesh, const TextureImage& texture, const std::string& subject);

}  // namespace lamina
