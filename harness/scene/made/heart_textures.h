// SPDX-License-Identifier: Apache-2.0
// The layers of the built-in heart's material, after Oat's figure 2: outside muscle (opaque) with windows of membrane and fat
// (transparent) and the coronary vessels, with a normal map of fibres, wrinkles and lobules; inside, arteries and veins
// branching over flesh. Everything is a function of the place on the heart, never of the texture coordinate, so nothing breaks
// at the seams; the margin around the chart shows what lies across the seam.
#pragma once

#include <cstdint>
#include <memory>

#include "harness/core/image.h"

namespace lamina {

// For the keys outer.albedo (alpha: its transparency), outer.normal and inner.albedo. Never null.
struct HeartTextures {
  std::shared_ptr<const TextureImage> outer_albedo, outer_normal, inner_albedo;
};
// `size` texels on a side, a power of two from 64 to 4096 (checked by make_heart). Made on a size's first call and kept; the
// same bytes each time. Safe from several threads.
HeartTextures heart_textures(uint32_t size);

}  // namespace lamina
