// SPDX-License-Identifier: Apache-2.0
// Tiles of many colours with light joints: blur of them shows at once.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// `count`: tiles along the texture's width and height; `seed`: which colours.
Object tiled_object(std::string name, Mesh mesh, glm::uvec2 count, uint32_t seed);

// One side of the unit tile: a square of 1 m that faces +z, around the origin, its texture upright.
Mesh upright_square();

}  // namespace lamina
