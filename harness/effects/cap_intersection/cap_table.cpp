// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/cap_intersection/cap_table.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "harness/core/error.h"
#include "harness/effects/cap_intersection/cap_area.h"

namespace lamina {
namespace {

// Stands for a ratio or a radius of 0, where the share has a limit: the difference from it is below half precision.
constexpr double nearly_none = 1e-6;

double share(double overlap, double ratio, double larger) {
  const double smaller = ratio * larger, d = larger + smaller * (1 - 2 * overlap);
  return cap_intersection_area(larger, smaller, d) / smaller_cap_area(larger, smaller);
}

}  // namespace

TextureImage make_cap_table(uint32_t size) {
  if (size < 2) throw Error(ErrorKind::bad_input, "caps", "cap_table", fmt::format("a side of {}; it takes 2 or more", size));
  const auto node = [size](uint32_t i) { return static_cast<double>(i) / (size - 1); };
  std::vector<uint16_t> halves;
  for (uint32_t z = 0; z < size; ++z)
    for (uint32_t y = 0; y < size; ++y)
      for (uint32_t x = 0; x < size; ++x) {
        const double ratio = std::max(node(y), nearly_none), larger = std::numbers::pi / 2 * std::max(node(z), nearly_none);
        halves.push_back(glm::packHalf1x16(static_cast<float>(share(node(x), ratio, larger))));
      }
  TextureImage table;
  table.name = "cap_table";
  table.format = Format::r16_float;
  table.width = table.height = table.depth = size;
  std::vector<std::byte>& texels = table.levels.emplace_back(halves.size() * sizeof(halves[0]));
  std::memcpy(texels.data(), halves.data(), texels.size());
  return table;
}

}  // namespace lamina
