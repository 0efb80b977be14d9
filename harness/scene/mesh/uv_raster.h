// SPDX-License-Identifier: Apache-2.0
// Which texels of the unwrap a triangle covers.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

inline constexpr uint32_t uv_raster_size = 512;  // texels on a side, for checks of unwraps

// Row * side + column of every texel whose centre the triangle covers, of `side` texels on a side, by the top-left rule:
// neighbours in the unwrap share none. Parts outside the unit square are left out.
std::vector<uint32_t> covered_texels(const Mesh& mesh, size_t triangle, uint32_t side = uv_raster_size);

}  // namespace lamina
