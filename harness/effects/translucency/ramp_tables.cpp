// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/ramp_tables.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "harness/scene/textures.h"

namespace lamina {
namespace {

double passed_at(uint32_t texel) { return std::exp(-8.0 * texel / (ramp_table_texels - 1)); }

Texels grey_ramp() {
  Texels ramp{ramp_table_texels, 1, {}};
  for (uint32_t i = 0; i < ramp_table_texels; ++i) ramp.rgba.emplace_back(glm::vec3(static_cast<float>(passed_at(i))), 1);
  return ramp;
}

// One level alone: a table is read without mips.
TextureImage base_level(TextureImage image, const char* name) {
  image.name = name;
  image.levels.resize(1);
  return image;
}

TextureImage halves(const char* name, bool squared) {
  std::vector<uint16_t> values;
  for (uint32_t i = 0; i < ramp_table_texels; ++i) {
    const double y = double(i) / (ramp_table_texels - 1);
    values.push_back(glm::packHalf1x16(static_cast<float>(std::exp(-8 * (squared ? y * y : y)))));
  }
  TextureImage table;
  table.name = name;
  table.format = Format::r16_float;
  table.width = ramp_table_texels;
  table.height = 1;
  std::vector<std::byte>& texels = table.levels.emplace_back(values.size() * sizeof(values[0]));
  std::memcpy(texels.data(), values.data(), texels.size());
  return table;
}

}  // namespace

TextureImage make_ramp_table_unorm8() {
  return base_level(*make_texture("ramp", grey_ramp(), TexelMeaning::data), "ramp_table_unorm8");
}
TextureImage make_ramp_table_srgb8() {
  return base_level(*make_texture("ramp", grey_ramp(), TexelMeaning::colour), "ramp_table_srgb8");
}
TextureImage make_ramp_table_half() { return halves("ramp_table_half", false); }
TextureImage make_ramp_table_squared() { return halves("ramp_table_squared", true); }

}  // namespace lamina
