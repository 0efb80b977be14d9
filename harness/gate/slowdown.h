// SPDX-License-Identifier: Apache-2.0
// A copy of variants and shaders in which one pass does a known amount of extra work. Calibration runs gates on it.
#pragma once

#include <filesystem>
#include <string>

#include "harness/manifest/library.h"

namespace lamina {

// Copies `home`'s variants/ and shaders/ to `folder` (which is made, and emptied first), with `taps` more texel fetches in each
// pixel of the fragment shader of `pass` of `variant`. Single texels, unfiltered, since one filtered tap can be more than is
// wanted; in every pixel, since a software rasterizer runs both sides of a branch. The picture stays the same. Throws
// Error(bad_input, "gate", ...) where the pass has no fragment shader of its own with a vec4 output at location 0 and a 2D
// texture, or the variant is not of `home`.
void write_slower_tree(const std::filesystem::path& home, const std::filesystem::path& folder, const VariantManifest& variant,
                       const std::string& pass, uint32_t taps);

// Copies likewise, with a variable that nothing uses in `pass` of every variant of the effect: other code that costs as much.
void write_changed_tree(const std::filesystem::path& home, const std::filesystem::path& folder, const EffectManifest& effect,
                        const std::string& pass);

}  // namespace lamina
