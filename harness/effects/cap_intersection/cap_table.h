// SPDX-License-Identifier: Apache-2.0
// The share of the smaller of two spherical caps that lies in the other, tabulated from cap_area.h: the 3D texture that
// shaders/cap_intersection/lut_cap.glsl reads under the name `cap_table`.
//
// Node i of an axis of n texels stands for i / (n - 1) of
//   x (width):  the overlap (r0 + r1 - d) / (2 smaller): 0 where the caps are apart, 1 where one lies in the other
//   y (height): smaller radius / larger radius
//   z (depth):  larger radius / (pi / 2)
// Larger caps need no place: the shader reduces them by their complements, so every regime's border is exact. Values run from 0
// to 1, both of which are met exactly; at ratio 0 and at radius 0 they are the limits (half-plane and disc, and two discs).
//
// What a table errs by, of the smaller cap's area, over all radii (half precision and filtering included; 64 KiB at 32^3):
//   16^3: +0.0063 -0.0064, rms 0.0014     32^3: +0.0030 -0.0030, rms 0.0004     64^3: +0.0014 -0.0015, rms 0.0001
#pragma once

#include <cstdint>

#include "harness/core/image.h"

namespace lamina {

inline constexpr uint32_t cap_table_size = 32;     // the smallest power of two below 0.005
inline constexpr double cap_table_error = 0.0035;  // no more than this of the smaller cap's area, with the size above

// The table with `size` texels on each side, r16_float; to be read with a linear filter and clamped. Throws Error(bad_input)
// for fewer than 2.
TextureImage make_cap_table(uint32_t size = cap_table_size);

}  // namespace lamina
