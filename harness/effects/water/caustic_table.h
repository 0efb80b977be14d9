// SPDX-License-Identifier: Apache-2.0
// Tileable textures that any shader may read: the light that small waves gather on a level bottom, the bubbles of foam, and the
// slopes of ripples.
#pragma once

#include "harness/core/image.h"

namespace lamina {

inline constexpr uint32_t caustic_side = 256;
// The mean of the lesser of the caustic table here and there, read between texels of its base level: its own mean is 1.
inline constexpr double caustic_lesser_mean = 0.7975;

// Two channels in half floats with their mips. The first, of mean 1: sunlight from straight above, refracted once by a sum of
// sines that is as wide as the tile, and gathered by where its rays land (rays of an even grid, each spread over four texels).
// The second: the mean of the lesser of the first here and there, in this level; 1 in the last.
TextureImage make_caustic_table();
// One channel, 0 to 1: how thick foam must be for its bubbles to cover this place; each threshold as frequent as another.
TextureImage make_foam_table();

// Two channels in half floats: slopes along x and z of a sum of sines as wide as the tile, each of mean square 1.
TextureImage make_ripple_table();

}  // namespace lamina
