// SPDX-License-Identifier: Apache-2.0
// An object of one colour, as scenes made by code use them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// `albedo`: linear, 0 to 1. Lit through apertures, of its vertices, where `apertures` says so.
Object coloured_object(std::string name, Mesh mesh, glm::vec3 albedo, bool apertures);

// A sphere; `middle` and `radius` in metres. Not lit through apertures.
Object coloured_ball(std::string name, glm::vec3 middle, float radius, glm::vec3 albedo);

}  // namespace lamina
