// SPDX-License-Identifier: Apache-2.0
#include "harness/core/format.h"

#include <algorithm>
#include <array>
#include <bit>

namespace lamina {
namespace {

struct FormatRow {
  Format format;
  std::string_view name;
  uint32_t bytes, channels;
};
constexpr std::array<FormatRow, 12> formats = {{
    {Format::r8_unorm, "r8_unorm", 1, 1},
    {Format::rg8_unorm, "rg8_unorm", 2, 2},
    {Format::rgba8_unorm, "rgba8_unorm", 4, 4},
    {Format::rgba8_srgb, "rgba8_srgb", 4, 4},
    {Format::r16_float, "r16_float", 2, 1},
    {Format::rg16_float, "rg16_float", 4, 2},
    {Format::rgba16_float, "rgba16_float", 8, 4},
    {Format::r32_float, "r32_float", 4, 1},
    {Format::rg32_float, "rg32_float", 8, 2},
    {Format::rgba32_float, "rgba32_float", 16, 4},
    {Format::r32_uint, "r32_uint", 4, 1},
    {Format::d32_float, "d32_float", 4, 1},
}};

}  // namespace

std::string_view name_of(Format format) { return formats[static_cast<size_t>(format)].name; }
uint32_t bytes_per_texel(Format format) { return formats[static_cast<size_t>(format)].bytes; }
uint32_t channels_of(Format format) { return formats[static_cast<size_t>(format)].channels; }

std::optional<Format> format_named(std::string_view name) {
  for (const FormatRow& row : formats)
    if (row.name == name) return row.format;
  return std::nullopt;
}

std::string_view name_of(Filter filter) { return filter_names[static_cast<size_t>(filter)]; }
std::string_view name_of(Wrap wrap) { return wrap_names[static_cast<size_t>(wrap)]; }

std::string name_of(Sampler sampler) {
  std::string name = std::string(name_of(sampler.filter)) + " " + std::string(name_of(sampler.wrap));
  if (sampler.wrap_v != sampler.wrap) name += " " + std::string(name_of(sampler.wrap_v));
  return name;
}

std::vector<Sampler> all_samplers() {
  std::vector<Sampler> all;
  for (const Filter filter : {Filter::nearest, Filter::linear, Filter::trilinear})
    for (const Wrap wrap : {Wrap::clamp, Wrap::repeat, Wrap::mirror})
      for (const Wrap wrap_v : {Wrap::clamp, Wrap::repeat, Wrap::mirror}) all.push_back({filter, wrap, wrap_v});
  return all;
}

uint32_t full_mip_levels(uint32_t width, uint32_t height) {
  return static_cast<uint32_t>(std::bit_width(std::max(width, height)));
}

}  // namespace lamina
