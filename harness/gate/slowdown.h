// SPDX-License-Identifier: Apache-2.0
// A copy of variants and shaders in which one pass does a known share of extra work: what a gate is tried on.
#pragma once

#include <filesystem>
#include <string>

#include "harness/plan/manifest.h"

namespace lamina {

// Extra taps run in some 8x8 blocks of pixels, chosen by a hash of their place: blocks, since a software rasterizer shades
// whole blocks at once, and a share of them, since one tap in every pixel can be more than is wanted.
struct ExtraTaps {
  uint32_t taps = 0;               // in each pixel of a chosen block
  uint32_t blocks_of_1024 = 1024;  // chosen
};

// Copies `home`'s variants/ and shaders/ to `folder` (which is made, and emptied first), with the extra taps in the fragment
// shader of `pass` of `variant`. The picture stays the same. Throws Error(bad_input, "gate", ...) where the pass has no
// fragment shader of its own with a vec4 output at location 0 and a 2D texture.
void write_slower_tree(const std::filesystem::path& home, const std::filesystem::path& folder, const VariantManifest& variant,
                       const std::string& pass, const ExtraTaps& extra);

}  // namespace lamina
