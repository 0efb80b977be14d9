// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/beckmann_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "harness/effects/skin/surface_reflection.h"

namespace lamina {
namespace {

constexpr uint32_t beckmann_texels = 256;

template <class Texel>
TextureImage beckmann_table(const char* name, Format format, bool centres, Texel (*packed)(double stored)) {
  const auto at = [&](uint32_t i) { return centres ? (i + 0.5) / beckmann_texels : double(i) / (beckmann_texels - 1); };
  std::vector<Texel> texels;
  for (uint32_t y = 0; y < beckmann_texels; ++y)
    for (uint32_t x = 0; x < beckmann_texels; ++x)
      texels.push_back(packed(std::min(1.0, 0.5 * std::pow(beckmann(at(x), std::max(at(y), 0.03125)), 0.1))));
  TextureImage table;
  table.name = name;
  table.format = format;
  table.width = table.height = beckmann_texels;
  std::vector<std::byte>& level = table.levels.emplace_back(texels.size() * sizeof(Texel));
  std::memcpy(level.data(), texels.data(), level.size());
  return table;
}

uint16_t half_of(double stored) { return glm::packHalf1x16(static_cast<float>(stored)); }
uint8_t code_of_stored(double stored) { return static_cast<uint8_t>(std::lround(255 * stored)); }
// 16 bits in a float, which a filter reads as a device's whole numbers of 16 bits are read: in floats.
float rounded_to_16_bits(double stored) { return static_cast<float>(static_cast<double>(std::lround(65535 * stored)) / 65535); }

}  // namespace

TextureImage make_beckmann_unorm8() {
  return beckmann_table<uint8_t>("beckmann_unorm8", Format::r8_unorm, false, code_of_stored);
}
TextureImage make_beckmann_unorm16() {
  return beckmann_table<float>("beckmann_unorm16", Format::r32_float, false, rounded_to_16_bits);
}
TextureImage make_beckmann_half() { return beckmann_table<uint16_t>("beckmann_half", Format::r16_float, false, half_of); }
TextureImage make_beckmann_centres() { return beckmann_table<uint16_t>("beckmann_centres", Format::r16_float, true, half_of); }

}  // namespace lamina
