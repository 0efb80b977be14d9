// SPDX-License-Identifier: Apache-2.0
// Reading files through OpenImageIO, and whole mip chains by box filter. The sRGB transfer function is that of IEC
// 61966-2-1:1999.
#include "harness/scene/textures.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <deque>

#include "harness/core/error.h"
#include "harness/core/srgb.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

// What lavapipe and every desktop driver of Vulkan 1.3 offers (maxImageDimension2D).
constexpr int max_texels_on_a_side = 16384;

// Bytes of texels from one byte of a PNG or Radiance file: deflate reaches 1032 (Gailly and Adler, zlib technical details),
// Radiance's runs, as floats, 192. Other formats pack flat pictures without such a bound.
constexpr uint64_t max_unpacked = 1032;

[[noreturn]] void refuse_texture(const std::string& name, const std::string& message) {
  throw Error(ErrorKind::bad_input, "texture", name, message);
}

std::byte unorm_code(float value) { return static_cast<std::byte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

// Transparency must not darken colours: ask for colour that is not multiplied by alpha.
OIIO::ImageSpec unassociated_alpha() {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  return config;
}

// Else OpenImageIO has every reader look at a damaged file, and some take bytes of any kind for a picture.
void only_the_named_reader() {
  static const bool set = OIIO::attribute("try_all_readers", 0);
  static_cast<void>(set);
}

// The codes of a file of 8 bits, read in bands where it has no tiles; grey becomes r = g = b, missing alpha 255.
std::vector<uint8_t> read_codes(OIIO::ImageInput& input, const std::string& name, size_t channels) {
  constexpr int band = 64;
  const OIIO::ImageSpec& spec = input.spec();
  const auto width = static_cast<size_t>(spec.width);
  std::vector<uint8_t> codes(width * size_t(spec.height) * 4);
  const int rows = spec.tile_width > 0 ? spec.height : std::min(band, spec.height);
  std::vector<uint8_t> read(width * size_t(rows) * channels);
  const bool grey = channels < 3, has_alpha = channels == 2 || channels == 4;
  // The reader of WebP does not do what unassociated_alpha() asks for: its codes are multiplied by alpha.
  const bool multiplied = channels == 4 && std::string_view(input.format_name()) == "webp";
  for (int y = 0; y < spec.height; y += rows) {
    const int end = std::min(y + rows, spec.height);
    const bool good = spec.tile_width > 0
                          ? input.read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::UINT8, read.data())
                          : input.read_scanlines(0, 0, spec.y + y, spec.y + end, 0, 0, static_cast<int>(channels),
                                                 OIIO::TypeDesc::UINT8, read.data());
    if (!good) refuse_texture(name, "cannot be decoded: " + input.geterror());
    uint8_t* out = &codes[size_t(y) * width * 4];
    for (size_t i = 0; i < width * size_t(end - y); ++i, out += 4) {
      const uint8_t* in = &read[i * channels];
      for (size_t c = 0; c < 3; ++c) out[c] = in[grey ? 0 : c];
      out[3] = has_alpha ? in[channels - 1] : 255;
      if (!multiplied || out[3] == 0) continue;
      for (size_t c = 0; c < 3; ++c) out[c] = static_cast<uint8_t>(std::min((2 * 255 * in[c] + out[3]) / (2 * out[3]), 255));
    }
  }
  return codes;
}

// Of a file of so many bytes.
Texels read_texels(OIIO::ImageInput& input, const std::string& name, bool srgb_colour, uint64_t file_bytes) {
  const OIIO::ImageSpec& spec = input.spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse_texture(name, "the picture has no texels");
  if (spec.width > max_texels_on_a_side || spec.height > max_texels_on_a_side)
    refuse_texture(
        name, fmt::format("{} x {} texels are too many; at most {} on a side", spec.width, spec.height, max_texels_on_a_side));
  const size_t channels = static_cast<size_t>(std::min(spec.nchannels, 4));
  const size_t texels = size_t(spec.width) * size_t(spec.height);
  if (spec.format == OIIO::TypeDesc::UINT8)
    return {static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height),
            TexelArray::of_codes(read_codes(input, name, channels), srgb_colour)};
  const std::string_view format = input.format_name();
  const bool bounded = format == "png" || format == "hdr";
  if (bounded && texels * spec.pixel_bytes() / max_unpacked > file_bytes)
    refuse_texture(name,
                   fmt::format("{} x {} texels are more than its {} bytes can hold", spec.width, spec.height, file_bytes));
  std::vector<float> values(texels * channels);
  if (!input.read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::FLOAT, values.data()))
    refuse_texture(name, "cannot be decoded: " + input.geterror());

  // Floating-point files (OpenEXR, Radiance) hold linear light by convention; only integer codes are sRGB-encoded.
  const bool decode = srgb_colour && !spec.format.is_floating_point();
  const auto colour = [&](float value) { return decode ? float(srgb_decode(double(value))) : value; };

  const bool grey = channels < 3;
  const bool has_alpha = channels == 2 || channels == 4;
  const auto width = static_cast<size_t>(spec.width);
  std::vector<glm::vec4> rgba(texels);
  for (size_t i = 0; i < texels; ++i) {
    const float* in = &values[i * channels];
    glm::vec4& out = rgba[i];
    for (int c = 0; c < 3; ++c) out[c] = colour(in[grey ? 0 : c]);
    out.a = has_alpha ? in[channels - 1] : 1.0f;
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(out[c])) refuse_texture(name, fmt::format("texel ({}, {}) is not finite", i % width, i / width));
  }
  return {static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height), std::move(rgba)};
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

glm::vec3 unit_or_flat(glm::vec3 sum) {
  const float length = glm::length(sum);
  return length > 1e-6f ? sum / length
                        : glm::vec3(0, 0, 1);  // far below what any two 8-bit normals can leave unless they cancel
}

// Codes of a row as the texture's format stores it.
void encode_row(std::span<const glm::vec4> row, TexelMeaning meaning, std::byte* out) {
  for (glm::vec4 texel : row) {
    if (meaning == TexelMeaning::normal) texel = glm::vec4(unit_or_flat(glm::vec3(texel)) * 0.5f + 0.5f, texel.a);
    if (meaning == TexelMeaning::normal_mean) texel = glm::vec4(glm::vec3(texel) * 0.5f + 0.5f, texel.a);
    for (int c = 0; c < 3; ++c)
      *out++ = meaning == TexelMeaning::colour ? std::byte{srgb_code(texel[c])} : unorm_code(texel[c]);
    *out++ = unorm_code(texel.a);
  }
}

// A mip level that is filtered row by row from the level above, before that is rounded or renormalized, so that every level is
// a box of the base; and all smaller levels, each from the rows of the one before. Only rows that are not yet whole are kept.
class SmallerLevels {
 public:
  SmallerLevels(TextureImage& texture, TexelMeaning meaning, uint32_t source_width, uint32_t source_height)
      : texture_(texture),
        meaning_(meaning),
        width_(std::max(1u, source_width / 2)),
        across_(box_taps(source_width, width_)),
        down_(box_taps(source_height, std::max(1u, source_height / 2))),
        level_(texture.levels.size()),
        filtered_(width_) {
    texture.levels.emplace_back(size_t{width_} * down_.size() * 4);
    if (width_ * down_.size() > 1)
      smaller_ = std::make_unique<SmallerLevels>(texture, meaning, width_, static_cast<uint32_t>(down_.size()));
  }

  // The next row of the level above, from its top.
  void take(std::span<const glm::vec4> row) {
    for (uint32_t x = 0; x < width_; ++x) {
      glm::vec4 sum{0};
      for (size_t i = 0; i < across_[x].weights.size(); ++i) sum += across_[x].weights[i] * row[across_[x].first + i];
      filtered_[x] = sum;
    }
    // A row weighs in at most two of this level's rows.
    while (begun_ < down_.size() && down_[begun_].first <= taken_) sums_.emplace_back(width_), ++begun_;
    const size_t first = begun_ - sums_.size();
    for (size_t i = 0; i < sums_.size(); ++i)
      for (uint32_t x = 0; x < width_; ++x)
        sums_[i][x] += down_[first + i].weights[taken_ - down_[first + i].first] * filtered_[x];
    ++taken_;
    while (!sums_.empty() && is_whole(begun_ - sums_.size())) {
      encode_row(sums_.front(), meaning_, &texture_.levels[level_][(begun_ - sums_.size()) * width_ * 4]);
      if (smaller_) smaller_->take(sums_.front());
      sums_.pop_front();
    }
  }

 private:
  bool is_whole(size_t row) const { return down_[row].first + down_[row].weights.size() == taken_; }

  TextureImage& texture_;
  const TexelMeaning meaning_;
  const uint32_t width_;
  const std::vector<Tap> across_, down_;
  const size_t level_;
  std::vector<glm::vec4> filtered_;          // the row across
  std::deque<std::vector<glm::vec4>> sums_;  // rows that are begun
  size_t begun_ = 0, taken_ = 0;             // rows of this level and of the one above
  std::unique_ptr<SmallerLevels> smaller_;
};

}  // namespace

const std::array<float, 256>& linear_of_srgb_codes() {
  static const std::array<float, 256> linear = [] {
    std::array<float, 256> made;
    for (size_t code = 0; code < made.size(); ++code) made[code] = static_cast<float>(srgb_decode(double(code) / 255));
    return made;
  }();
  return linear;
}

Texels load_texels(const std::filesystem::path& file, bool srgb_colour) {
  const OIIO::ImageSpec config = unassociated_alpha();
  only_the_named_reader();
  if (const auto input = OIIO::ImageInput::open(file.string(), &config))
    return read_texels(*input, file.string(), srgb_colour, std::filesystem::file_size(file));
  const std::string why = OIIO::geterror();
  if (!std::filesystem::is_regular_file(file)) refuse_texture(file.string(), "cannot be read as a picture: " + why);
  const std::string bytes = read_file(file, "textures");  // its ending may be another format's
  return decode_texels(std::as_bytes(std::span(bytes)), file.string(), srgb_colour);
}

Texels decode_texels(std::span<const std::byte> encoded_file, const std::string& name, bool srgb_colour) {
  // OpenImageIO chooses a reader by the name's ending alone: glTF's own formats first, then others that read from memory.
  only_the_named_reader();
  std::string why;
  for (const char* ending : {"png", "jpg", "webp", "exr", "hdr"}) {
    OIIO::Filesystem::IOMemReader memory(encoded_file.data(), encoded_file.size());
    OIIO::ImageSpec config = unassociated_alpha();
    void* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    if (const auto input = OIIO::ImageInput::open(fmt::format("picture.{}", ending), &config))
      return read_texels(*input, name, srgb_colour, encoded_file.size());
    why += fmt::format("; {}: {}", ending, OIIO::geterror());
  }
  refuse_texture(name, "cannot be read as a picture" + why);
}

std::shared_ptr<const TextureImage> make_texture(std::string name, const Texels& base, TexelMeaning meaning,
                                                 std::optional<float> alpha) {
  if (base.width == 0 || base.height == 0 || base.rgba.size() != size_t{base.width} * base.height)
    refuse_texture(name, fmt::format("{} texels do not fill {} x {}", base.rgba.size(), base.width, base.height));
  auto texture = std::make_shared<TextureImage>();
  texture->name = std::move(name);
  texture->format = meaning == TexelMeaning::colour ? Format::rgba8_srgb : Format::rgba8_unorm;
  texture->width = base.width;
  texture->height = base.height;
  texture->wraps = base.wraps;

  const bool normals = meaning == TexelMeaning::normal || meaning == TexelMeaning::normal_mean;
  const std::vector<uint8_t>& codes = base.rgba.codes();
  const bool stored = !normals && !codes.empty() && base.rgba.srgb() == (meaning == TexelMeaning::colour);
  texture->levels.emplace_back(size_t{base.width} * base.height * 4);
  std::unique_ptr<SmallerLevels> smaller;
  if (base.rgba.size() > 1) smaller = std::make_unique<SmallerLevels>(*texture, meaning, base.width, base.height);
  std::vector<glm::vec4> row(base.width);
  for (uint32_t y = 0; y < base.height; ++y) {
    const size_t first = size_t{y} * base.width;
    for (size_t x = 0; x < row.size(); ++x) {
      row[x] = base.rgba[first + x];
      if (normals) row[x] = glm::vec4(unit_or_flat(glm::vec3(row[x]) * 2.0f - 1.0f), row[x].a);
      if (alpha) row[x].a = *alpha;
    }
    std::byte* out = &texture->levels.front()[4 * first];
    if (stored) {
      std::memcpy(out, &codes[4 * first], 4 * row.size());  // they are what would come of them
      for (size_t x = 0; alpha && x < row.size(); ++x) out[4 * x + 3] = unorm_code(*alpha);
    } else {
      encode_row(row, meaning, out);
    }
    if (smaller) smaller->take(row);
  }
  return texture;
}

std::shared_ptr<const TextureImage> constant_texture(std::string name, glm::vec4 linear, TexelMeaning meaning) {
  return make_texture(std::move(name), Texels{1, 1, {linear}}, meaning);
}

Texels level_texels(const TextureImage& texture, size_t level) {
  const std::vector<std::byte>& bytes = texture.levels.at(level);
  const auto* codes = reinterpret_cast<const uint8_t*>(bytes.data());
  return {std::max(texture.width >> level, 1u), std::max(texture.height >> level, 1u),
          TexelArray::of_codes({codes, codes + bytes.size()}, texture.format == Format::rgba8_srgb), texture.wraps};
}

Image image_of(const Texels& texels) {
  Image image{static_cast<int>(texels.width), static_cast<int>(texels.height), {}};
  image.rgba.reserve(4 * texels.rgba.size());
  for (const glm::vec4 texel : texels.rgba)
    for (int c = 0; c < 4; ++c) image.rgba.push_back(texel[c]);
  return image;
}

Texels base_texels(const TextureImage& texture) { return level_texels(texture, 0); }

Texels resized(const Texels& source, uint32_t width, uint32_t height) {
  if (source.width == width && source.height == height) return source;
  std::vector<glm::vec4> result(size_t{width} * height);
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
        const size_t first = row * source.width;
        return glm::mix(source.rgba[first + across.first], source.rgba[first + across.second], across.weight);
      };
      result[size_t{y} * width + x] = glm::mix(mixed(down.first), mixed(down.second), down.weight);
    }
  }
  return {width, height, std::move(result), source.wraps};
}

}  // namespace lamina
