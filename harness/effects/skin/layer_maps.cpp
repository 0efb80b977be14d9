// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/layer_maps.h"

#include <algorithm>

#include "harness/scene/textures.h"

namespace lamina {
namespace {

Texture tinted(const EffectValues& so_far, const char* name, size_t level, glm::vec3 tint) {
  const TextureImage& albedo = *so_far.textures.at("skin_albedo");
  Texels texels = level_texels(albedo, std::min(level, albedo.levels.size() - 1));
  for (glm::vec4& texel : texels.rgba) texel = glm::vec4(glm::min(glm::vec3(texel) * tint, glm::vec3(1)), texel.a);
  return make_texture(name, texels, TexelMeaning::colour);
}

}  // namespace

Texture epidermal_map(const EffectValues& so_far) { return tinted(so_far, "epidermal", 1, {0.9f, 1.1f, 1.15f}); }
Texture subdermal_map(const EffectValues& so_far) { return tinted(so_far, "subdermal", 3, {1.15f, 0.85f, 0.775f}); }

}  // namespace lamina
