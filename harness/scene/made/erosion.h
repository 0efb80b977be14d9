// SPDX-License-Identifier: Apache-2.0
// Mountains as rivers leave them: land is lifted, streams cut down by the stream-power law dh/dt = uplift - K sqrt(A) slope, A
// being the area that drains through a point, and slopes steeper than rock can stand slide.
// Sources: Braun and Willett, "A very efficient O(n), implicit and parallel method to solve the stream power equation governing
// fluvial incision and landscape evolution", Geomorphology 180, 2013 (the implicit step); Cordonnier et al., "Large Scale
// Terrain Generation from Tectonic Uplift and Fluvial Erosion", Computer Graphics Forum 35, 2016 (its use for scenes).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lamina {

// side * side points, row after row, `spacing_m` apart.
struct Terrain {
  uint32_t side = 0;
  float spacing_m = 0;
  std::vector<float> height_m;
  std::vector<float> drained_m2;  // the area whose water passes the point, its own cell included

  float at(uint32_t column, uint32_t row) const { return height_m[row * side + column]; }
};

struct Erosion {
  uint32_t side = 257;  // 2^k + 1, at least 65: worked out from coarse to fine
  float extent_m = 5120;
  float relief_m = 1500;  // from the outlet, at 0, to the highest peak
  float steepest = 0.9f;  // rise over run that does not slide
  uint32_t seed = 1;
};

// A mountain valley that runs from the far edge (row 0) to its outlet in the middle of the near edge (last row); no water
// leaves elsewhere.
Terrain eroded_valley(const Erosion& options);

}  // namespace lamina
