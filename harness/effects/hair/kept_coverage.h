// SPDX-License-Identifier: Apache-2.0
// Mips of a cut-out texture that keep their coverage. After Castaño, "Computing Alpha Mipmaps", The Witness, 2010: each level's
// alpha is scaled so that the alpha test passes as large a share of it as of the base level.
#pragma once

#include "harness/core/image.h"

namespace lamina {

// The share of a level's texels whose alpha is at least `cutoff` (0 to 1). The texture is rgba8.
double alpha_coverage(const TextureImage& texture, size_t level, double cutoff);

// The same texture with alphas scaled; the base level as it was. Coverage is kept to a texel where alphas can be told apart.
TextureImage with_kept_coverage(const TextureImage& texture, double cutoff);

}  // namespace lamina
