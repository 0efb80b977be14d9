// SPDX-License-Identifier: Apache-2.0
// Scenes for more than two layers and for the shadows between them.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The heart of heart.h in three layers: a membrane over its muscle and vessels, and those over the inner veins.
Scene make_three_layer_heart(float time_s);
// A block and a slab on it, both of four sheets of marble that clear seams cut through.
Scene make_marble_stack();
// A plate under a lattice of opaque bars, far below which lies pale stone: the bars' shadows show, most of all where the light
// is low and where the plate is seen from the side. Layers shade each other here.
Scene make_lattice_plate();

}  // namespace lamina
