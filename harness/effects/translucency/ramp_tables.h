// SPDX-License-Identifier: Apache-2.0
// Ramps of exp(-x), x from 0 (the first texel's centre) to 8 (the last's), as shaders/thickness_ramp reads them.
#pragma once

#include "harness/core/image.h"

namespace lamina {

inline constexpr uint32_t ramp_table_texels = 256;

// A linear filter of 8-bit texels is rounded to 8 bits on some devices; of half floats, and of sRGB ones, it is not.
TextureImage make_ramp_table_unorm8();
TextureImage make_ramp_table_srgb8();
TextureImage make_ramp_table_half();
// exp(-8 y^2) at y from 0 to 1: more texels where it is steep.
TextureImage make_ramp_table_squared();

}  // namespace lamina
