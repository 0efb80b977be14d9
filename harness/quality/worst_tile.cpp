// SPDX-License-Identifier: Apache-2.0
// Where an error map is worst, so that a person knows where to look first.
#include <algorithm>

#include "harness/core/error.h"
#include "harness/quality/quality.h"

namespace lamina {

WorstTile worst_tile(const std::vector<float>& map, int width, int height) {
  if (width < 1 || height < 1 || map.size() != static_cast<size_t>(width) * static_cast<size_t>(height))
    throw Error(ErrorKind::failed, "quality", "worst tile", "the map is empty, or not as long as its width and height say");
  WorstTile worst{.flip = -1};
  for (int y = 0; y < height; y += worst_tile_px)
    for (int x = 0; x < width; x += worst_tile_px) {
      const int right = std::min(x + worst_tile_px, width), lower = std::min(y + worst_tile_px, height);
      double sum = 0;
      for (int row = y; row < lower; ++row)
        for (int column = x; column < right; ++column) sum += map[static_cast<size_t>(row) * width + column];
      if (const double mean = sum / ((right - x) * (lower - y)); mean > worst.flip) worst = {.x = x, .y = y, .flip = mean};
    }
  return worst;
}

}  // namespace lamina
