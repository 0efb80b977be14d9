// SPDX-License-Identifier: Apache-2.0
// The C++ of the layered material: variants/layered_material/effect.toml names it.
#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "harness/effects/layered_material/layer_truth.h"
#include "harness/manifest/effect_code.h"
#include "harness/scene/effect_values.h"
#include "harness/scene/made/kept.h"
#include "harness/scene/made/marble.h"

namespace lamina {
namespace {

// The inner layer of an object that brings none. The same picture for all of a size, so each size is made once.
Texture marble_layer(const EffectValues& so_far) {
  static std::mutex making;
  static std::map<std::pair<uint32_t, uint32_t>, Texture> made;
  const TextureImage& outer = *so_far.textures.at("outer_albedo");
  // At most 1024: the light map is as large as this layer, and the marbling has nothing finer to show.
  const uint32_t width = std::clamp(outer.width, 512u, 1024u), height = std::clamp(outer.height, 512u, 1024u);
  const std::lock_guard lock(making);
  Texture& layer = made[{width, height}];
  if (!layer)
    layer = kept_textures(fmt::format("marble_{}x{}", width, height), [&] {
              Texels texels = marble(width, height, 1);
              for (glm::vec4& texel : texels.rgba) texel.a = 0.5f;  // what lies below it, if anything, shows as much as it does
              return std::vector{make_texture("inner layer", texels, TexelMeaning::colour)};
            }).front();
  return layer;
}

}  // namespace

void add_layered_material(EffectCode& code) {
  code.makers["marble"] = marble_layer;
  code.truths["layers"] = layer_truth;
}

}  // namespace lamina
