// SPDX-License-Identifier: Apache-2.0
// Pictures in memory. Row 0 is the top row, x runs right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/core/format.h"

namespace lamina {

// A picture as rendered: RGBA, four floats a pixel, linear light (Rec. 709 primaries), unbounded, alpha as the last pass wrote
// it.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgba;  // width * height * 4
};

// Which pixels count: 1 counts, 0 does not.
struct Mask {
  int width = 0, height = 0;
  std::vector<uint8_t> on;  // width * height
};

// What lies beyond a picture's borders.
struct TextureWraps {
  Wrap u = Wrap::repeat, v = Wrap::repeat;
};

// A texture ready to upload: every level of its mip chain, in `format`. Level 0 first, slices in order, rows top to bottom, no
// padding.
struct TextureImage {
  std::string name;
  Format format = Format::rgba8_unorm;
  uint32_t width = 0, height = 0;
  std::vector<std::vector<std::byte>> levels;
  uint32_t depth = 1;                 // above 1: a 3D texture, of one level
  std::optional<TextureWraps> wraps;  // as the model that it comes from asks; else as who reads it says
};

}  // namespace lamina
