// SPDX-License-Identifier: Apache-2.0
// A picture made by code for the inner layer of models that bring none: warm flesh and jade, marbled, with veins. It tiles in
// both directions, so that no seam shows where a mesh's unwrap meets the border.
//
// Gradient noise in the plane after Perlin, "Improving Noise", SIGGRAPH 2002, on a lattice that wraps; the marbling is noise
// read at places that noise has moved, after Perlin, "An Image Synthesizer", SIGGRAPH 1985.
#pragma once

#include "harness/scene/textures.h"

namespace lamina {

// Linear colours, alpha 1. The same size and seed give the same texels; another size gives the same picture at that size.
Texels marble(uint32_t width, uint32_t height, uint32_t seed);

}  // namespace lamina
