// SPDX-License-Identifier: Apache-2.0
// Skin for the head of head_form.h: colours with blood and brows, pores and fine lines as a normal map, where the surface
// shines, and where light comes through. All are functions of the place on the head.
#pragma once

#include <memory>

#include "harness/core/image.h"
#include "harness/scene/made/head_form.h"

namespace lamina {

struct HeadTextures {
  // For the keys skin.albedo, skin.normal, skin.specular_map (data) and skin.translucency. Never null.
  std::shared_ptr<const TextureImage> albedo, normal, specular, translucency;
};
// `tone`: linear colour of plain skin. `texels` along a side, a power of two. Where the maps shine: the ranges that d'Eon and
// Luebke's head had (GPU Gems 3, chapter 14), nose, lips and forehead shinier.
HeadTextures head_textures(glm::vec3 tone, uint32_t texels);

}  // namespace lamina
