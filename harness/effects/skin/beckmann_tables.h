// SPDX-License-Identifier: Apache-2.0
// Beckmann's distribution as a table, as Clement stores it: 0.5 PH^0.1, cut off above 1, over N.H (x) and the slope m (y), 256
// texels a side.
#pragma once

#include "harness/core/image.h"

namespace lamina {

// The first and the last texel hold 0 and 1; whole numbers of 8 bits, of 16
// (in floats: targets and textures have no 16-bit whole numbers here), or half floats.
TextureImage make_beckmann_unorm8();
TextureImage make_beckmann_unorm16();
TextureImage make_beckmann_half();
// Texels hold the values at their centres, so that none holds N.H = 1; half floats.
TextureImage make_beckmann_centres();

}  // namespace lamina
