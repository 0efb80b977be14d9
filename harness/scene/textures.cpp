// SPDX-License-Identifier: Apache-2.0
// Reading files through OpenImageIO, and whole mip chains by box filter. The sRGB transfer function is that of IEC
// 61966-2-1:1999.
#include "harness/scene/textures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/core/error.h"

namespace lamina {
namespace {

// What lavapipe and every desktop driver of Vulkan 1.3 offers (maxImageDimension2D).
constexpr int max_texels_on_a_side = 16384;

[[noreturn]] void refuse_texture(const std::string& name, const std::string& message) {
  throw Error(ErrorKind::bad_input, "texture", name, message);
}

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Linear values halfway between the codes k and k+1 as encoded: a value's code is the number of boundaries at or below it.
std::array<float, 255> srgb_code_boundaries() {
  std::array<float, 255> boundaries;
  for (size_t k = 0; k < boundaries.size(); ++k) boundaries[k] = static_cast<float>(linear_from_srgb((double(k) + 0.5) / 255));
  return boundaries;
}

std::byte srgb_code(float linear) {
  static const std::array<float, 255> boundaries = srgb_code_boundaries();
  return static_cast<std::byte>(std::upper_bound(boundaries.begin(), boundaries.end(), linear) - boundaries.begin());
}

std::byte unorm_code(float value) { return static_cast<std::byte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

// Linear values of the 256 codes.
std::array<float, 256> decoded_srgb_codes() {
  std::array<float, 256> linear;
  for (size_t k = 0; k < linear.size(); ++k) linear[k] = static_cast<float>(linear_from_srgb(double(k) / 255));
  return linear;
}

// Transparency must not darken colours: ask for colour that is not multiplied by alpha.
OIIO::ImageSpec unassociated_alpha() {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  return config;
}

Texels read_texels(OIIO::ImageInput& input, const std::string& name, bool srgb_colour) {
  const OIIO::ImageSpec& spec = input.spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse_texture(name, "the picture has no texels");
  if (spec.width > max_texels_on_a_side || spec.height > max_texels_on_a_side)
    refuse_texture(
        name, fmt::format("{} x {} texels are too many; at most {} on a side", spec.width, spec.height, max_texels_on_a_side));
  const size_t channels = static_cast<size_t>(std::min(spec.nchannels, 4));
  const size_t texels = size_t(spec.width) * size_t(spec.height);
  std::vector<float> values(texels * channels);
  if (!input.read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::FLOAT, values.data()))
    refuse_texture(name, "cannot be decoded: " + input.geterror());

  // Floating-point files (OpenEXR, Radiance) hold linear light by convention; only integer codes are sRGB-encoded.
  const bool decode = srgb_colour && !spec.format.is_floating_point();
  // Integer files have few distinct values, repeated over many texels.
  const std::array<float, 256> linear_of_code = decoded_srgb_codes();
  const bool eight_bits = spec.format == OIIO::TypeDesc::UINT8;
  const auto colour = [&](float value) {
    if (!decode) return value;
    return eight_bits ? linear_of_code[static_cast<size_t>(std::lround(value * 255))] : float(linear_from_srgb(value));
  };

  const bool grey = channels < 3;
  const bool has_alpha = channels == 2 || channels == 4;
  Texels result{static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height), std::vector<glm::vec4>(texels)};
  for (size_t i = 0; i < texels; ++i) {
    const float* in = &values[i * channels];
    glm::vec4& out = result.rgba[i];
    for (int c = 0; c < 3; ++c) out[c] = colour(in[grey ? 0 : c]);
    out.a = has_alpha ? in[channels - 1] : 1.0f;
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(out[c]))
        refuse_texture(name, fmt::format("texel ({}, {}) is not finite", i % result.width, i / result.width));
  }
  return result;
}

// The box filter along one axis: destination texel i covers the sources from i * ratio to (i + 1) * ratio, whole or in part, so
// that every source weighs the same in all and the mean stays.
struct Tap {
  uint32_t first;
  std::vector<float> weights;
};
std::vector<Tap> box_taps(uint32_t source, uint32_t destination) {
  std::vector<Tap> taps(destination);
  for (uint32_t i = 0; i < destination; ++i) {
    // In units of 1 / destination of a source texel everything is whole, and so exact.
    const uint64_t begin = uint64_t{i} * source, end = begin + source;
    taps[i].first = static_cast<uint32_t>(begin / destination);
    for (uint64_t texel = begin / destination; texel * destination < end; ++texel) {
      const uint64_t covered = std::min(end, (texel + 1) * destination) - std::max(begin, texel * destination);
      taps[i].weights.push_back(static_cast<float>(double(covered) / double(source)));
    }
  }
  return taps;
}

Texels half_size(const Texels& source) {
  Texels half{std::max(1u, source.width / 2), std::max(1u, source.height / 2), {}};
  half.rgba.resize(size_t{half.width} * half.height);
  const std::vector<Tap> across = box_taps(source.width, half.width), down = box_taps(source.height, half.height);
  for (uint32_t y = 0; y < half.height; ++y) {
    for (uint32_t x = 0; x < half.width; ++x) {
      glm::vec4 sum{0};
      for (size_t j = 0; j < down[y].weights.size(); ++j) {
        const glm::vec4* row = &source.rgba[(down[y].first + j) * source.width + across[x].first];
        glm::vec4 row_sum{0};
        for (size_t i = 0; i < across[x].weights.size(); ++i) row_sum += across[x].weights[i] * row[i];
        sum += down[y].weights[j] * row_sum;
      }
      half.rgba[size_t{y} * half.width + x] = sum;
    }
  }
  return half;
}

glm::vec3 unit_or_flat(glm::vec3 sum) {
  const float length = glm::length(sum);
  return length > 1e-6f ? sum / length
                        : glm::vec3(0, 0, 1);  // far below what any two 8-bit normals can leave unless they cancel
}

// One level in the texture's format. Normals come as vectors, everything else as it is stored.
std::vector<std::byte> encoded(const Texels& level, TexelMeaning meaning) {
  std::vector<std::byte> bytes(level.rgba.size() * 4);
  for (size_t i = 0; i < level.rgba.size(); ++i) {
    glm::vec4 texel = level.rgba[i];
    if (meaning == TexelMeaning::normal) texel = glm::vec4(unit_or_flat(glm::vec3(texel)) * 0.5f + 0.5f, texel.a);
    if (meaning == TexelMeaning::normal_mean) texel = glm::vec4(glm::vec3(texel) * 0.5f + 0.5f, texel.a);
    for (int c = 0; c < 3; ++c) bytes[i * 4 + c] = meaning == TexelMeaning::colour ? srgb_code(texel[c]) : unorm_code(texel[c]);
    bytes[i * 4 + 3] = unorm_code(texel.a);
  }
  return bytes;
}

}  // namespace

Texels load_texels(const std::filesystem::path& file, bool srgb_colour) {
  const OIIO::ImageSpec config = unassociated_alpha();
  const auto input = OIIO::ImageInput::open(file.string(), &config);
  if (!input) refuse_texture(file.string(), "cannot be read as a picture: " + OIIO::geterror());
  return read_texels(*input, file.string(), srgb_colour);
}

Texels decode_texels(std::span<const std::byte> encoded_file, const std::string& name, bool srgb_colour) {
  // OpenImageIO chooses a reader by the name's ending alone: glTF's own formats first, then others that read from memory.
  std::string why;
  for (const char* ending : {"png", "jpg", "webp", "exr", "hdr"}) {
    OIIO::Filesystem::IOMemReader memory(encoded_file.data(), encoded_file.size());
    OIIO::ImageSpec config = unassociated_alpha();
    void* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    if (const auto input = OIIO::ImageInput::open(fmt::format("picture.{}", ending), &config))
      return read_texels(*input, name, srgb_colour);
    why += fmt::format("; {}: {}", ending, OIIO::geterror());
  }
  refuse_texture(name, "cannot be read as a picture" + why);
}

std::shared_ptr<const TextureImage> make_texture(std::string name, const Texels& base, TexelMeaning meaning) {
  if (base.width == 0 || base.height == 0 || base.rgba.size() != size_t{base.width} * base.height)
    refuse_texture(name, fmt::format("{} texels do not fill {} x {}", base.rgba.size(), base.width, base.height));
  auto texture = std::make_shared<TextureImage>();
  texture->name = std::move(name);
  texture->format = meaning == TexelMeaning::colour ? Format::rgba8_srgb : Format::rgba8_unorm;
  texture->width = base.width;
  texture->height = base.height;

  Texels level = base;
  if (meaning == TexelMeaning::normal || meaning == TexelMeaning::normal_mean)
    for (glm::vec4& texel : level.rgba) texel = glm::vec4(unit_or_flat(glm::vec3(texel) * 2.0f - 1.0f), texel.a);
  texture->levels.push_back(encoded(level, meaning));
  // Each level is filtered from the one above before that is rounded or renormalized, so every level is a box of the base.
  while (level.width > 1 || level.height > 1) {
    level = half_size(level);
    texture->levels.push_back(encoded(level, meaning));
  }
  return texture;
}

std::shared_ptr<const TextureImage> constant_texture(std::string name, glm::vec4 linear, TexelMeaning meaning) {
  return make_texture(std::move(name), Texels{1, 1, {linear}}, meaning);
}

Texels level_texels(const TextureImage& texture, size_t level) {
  const std::array<float, 256> linear_of_code = decoded_srgb_codes();
  const std::vector<std::byte>& codes = texture.levels.at(level);
  Texels texels{std::max(texture.width >> level, 1u), std::max(texture.height >> level, 1u),
                std::vector<glm::vec4>(codes.size() / 4)};
  for (size_t i = 0; i < codes.size(); ++i) {
    const auto code = std::to_integer<uint8_t>(codes[i]);
    const bool colour = texture.format == Format::rgba8_srgb && i % 4 != 3;
    texels.rgba[i / 4][static_cast<int>(i % 4)] = colour ? linear_of_code[code] : float(code) / 255;
  }
  return texels;
}

Texels base_texels(const TextureImage& texture) { return level_texels(texture, 0); }

Texels resized(const Texels& source, uint32_t width, uint32_t height) {
  if (source.width == width && source.height == height) return source;
  Texels result{width, height, std::vector<glm::vec4>(size_t{width} * height)};
  // The two neighbours of destination texel i along an axis, and the weight of the second.
  struct Neighbours {
    size_t first, second;
    float weight;
  };
  const auto neighbours = [](uint32_t i, uint32_t from, uint32_t to) {
    const double centre = std::clamp((i + 0.5) * from / to - 0.5, 0.0, double(from - 1));
    const auto first = static_cast<size_t>(centre);
    return Neighbours{first, std::min<size_t>(first + 1, from - 1), static_cast<float>(centre - double(first))};
  };
  for (uint32_t y = 0; y < height; ++y) {
    const Neighbours down = neighbours(y, source.height, height);
    for (uint32_t x = 0; x < width; ++x) {
      const Neighbours across = neighbours(x, source.width, width);
      const auto mixed = [&](size_t row) {
        const glm::vec4* texels = &source.rgba[row * source.width];
        return glm::mix(texels[across.first], texels[across.second], across.weight);
      };
      result.rgba[size_t{y} * width + x] = glm::mix(mixed(down.first), mixed(down.second), down.weight);
    }
  }
  return result;
}

}  // namespace lamina
