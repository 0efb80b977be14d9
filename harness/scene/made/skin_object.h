// SPDX-License-Identifier: Apache-2.0
// Objects with skin, and a globe to put it on, as scenes made by code use them.
#pragma once

#include <map>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// `numbers`: by scene key ("skin.specular").
Object skin_object(std::string name, Mesh mesh, glm::vec3 albedo, const std::map<std::string, double>& numbers = {});

// A sphere of radius 1 around the origin whose unwrap is one chart: u is longitude, from the back (-z) by -x, the front and +x
// to the back again, and v is polar angle from the top (+y). The poles are cut off by `cut` radians.
Mesh globe_mesh(uint32_t columns, uint32_t rows, float cut = 0.01f);

}  // namespace lamina
