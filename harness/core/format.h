// SPDX-License-Identifier: Apache-2.0
// Texel formats that every backend offers, by the names used in manifests and records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

enum class Format : uint8_t {
  r8_unorm,
  rg8_unorm,
  rgba8_unorm,
  rgba8_srgb,  // rgb stored sRGB-encoded and decoded to linear before filtering; alpha linear
  r16_float,
  rg16_float,
  rgba16_float,
  r32_float,
  rg32_float,
  rgba32_float,
  r32_uint,
  d32_float,  // depth
};

// "rgba16_float" and so on.
std::string_view name_of(Format format);
// The format called `name`, or nothing.
std::optional<Format> format_named(std::string_view name);
// Size of one texel.
uint32_t bytes_per_texel(Format format);
uint32_t channels_of(Format format);
inline bool is_depth(Format format) { return format == Format::d32_float; }

enum class Filter : uint8_t {
  nearest,    // one texel of the base level
  linear,     // bilinear, base level; between slices too where the texture is 3D
  trilinear,  // bilinear in the two nearest levels of the mip chain
};
enum class Wrap : uint8_t { clamp, repeat, mirror };  // what lies beyond the border; mirror: every other repetition is turned
struct Sampler {
  Filter filter = Filter::linear;
  Wrap wrap = Wrap::clamp;  // along u, and between a 3D texture's slices
  Wrap wrap_v = wrap;
  bool operator==(const Sampler&) const = default;
};
// As manifests and records say them, in the order of the enumerators.
inline const std::vector<std::string> filter_names = {"nearest", "linear", "trilinear"};
inline const std::vector<std::string> wrap_names = {"clamp", "repeat", "mirror"};
std::string_view name_of(Filter filter);
std::string_view name_of(Wrap wrap);
// "linear clamp", "linear repeat mirror"
std::string name_of(Sampler sampler);
// Every sampler has a place among so many.
inline constexpr size_t sampler_count = 27;
inline constexpr size_t place_of(Sampler sampler) {
  return 9 * static_cast<size_t>(sampler.filter) + 3 * static_cast<size_t>(sampler.wrap) + static_cast<size_t>(sampler.wrap_v);
}
std::vector<Sampler> all_samplers();

// Levels of a full mip chain: floor(log2(max(width, height))) + 1.
uint32_t full_mip_levels(uint32_t width, uint32_t height);

}  // namespace lamina
