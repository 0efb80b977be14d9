// SPDX-License-Identifier: Apache-2.0
// Textures from files, from arrays, and made by code; every one with its whole mip chain, filtered in linear light.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>

#include "harness/core/image.h"
#include "harness/scene/texel_array.h"

namespace lamina {

// Pictures before they become textures: four numbers a texel, linear light, rows top to bottom.
struct Texels {
  uint32_t width = 0, height = 0;
  TexelArray rgba;
  std::optional<TextureWraps> wraps{};  // handed on to the texture
};

// Any file that OpenImageIO reads by its ending, and those of decode_texels() whatever their ending. srgb_colour: rgb is
// sRGB-encoded in the file and decoded to linear here (alpha is always linear, and floating-point files such as OpenEXR are
// linear already); otherwise values are taken as they are (normal maps, masks). Grey becomes r = g = b; missing alpha is 1.
// Throws Error(bad_input) naming the file where it is missing, damaged, over 16384 texels on a side, of more texels than its
// bytes can hold (PNG of 16 bits, Radiance), or holds values that are not finite.
Texels load_texels(const std::filesystem::path& file, bool srgb_colour);
// The same from an encoded file in memory (a .glb's buffer view): PNG, JPEG, WebP, OpenEXR or Radiance. `name` is used in
// errors.
Texels decode_texels(std::span<const std::byte> encoded, const std::string& name, bool srgb_colour);

// What a mip level's texel means, and so how levels are filtered and stored.
enum class TexelMeaning {
  colour,       // rgba8_srgb: box filter in linear light, then encoded; alpha linear
  normal,       // rgba8_unorm: vectors n = 2 t - 1 averaged and renormalized (zero sums become (0,0,1))
  data,         // rgba8_unorm: box filter
  normal_mean,  // rgba8_unorm: unit vectors at the base, box filter below: a mean's length shows how much they scatter
};
// `alpha`: of every texel, in place of the base's own. Takes the levels' own memory and some rows. Throws Error(bad_input)
// where the texels do not fill width * height.
std::shared_ptr<const TextureImage> make_texture(std::string name, const Texels& base, TexelMeaning meaning,
                                                 std::optional<float> alpha = std::nullopt);

// One-texel textures for materials that have only a factor.
std::shared_ptr<const TextureImage> constant_texture(std::string name, glm::vec4 linear, TexelMeaning meaning);

// A level of a texture as texels again: colours decoded to linear, other values as stored, 0 to 1.
Texels level_texels(const TextureImage& texture, size_t level);
Texels base_texels(const TextureImage& texture);  // level 0

// As a picture that metrics take.
Image image_of(const Texels& texels);

// The same picture at another size: bilinear between texel centres, edges held. Meant for enlarging; it does not filter.
Texels resized(const Texels& source, uint32_t width, uint32_t height);

}  // namespace lamina
