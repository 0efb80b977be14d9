// SPDX-License-Identifier: Apache-2.0
// Hulls of fog, as scenes made by code use them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// A hull of fog, or a hole in fog. `share`: of the scene's density, above 0 and up to 1.
Object fog_hull(std::string name, Mesh mesh, const glm::mat4& world_from_object, float share, bool hole = false);

// A round hull: half axes `radii` in metres, turned about y.
Object fog_ball(std::string name, glm::vec3 centre, glm::vec3 radii, float share, float turn_degrees = 0);

// A box from `low` to `high`.
Object fog_box(std::string name, glm::vec3 low, glm::vec3 high, float share, bool hole = false);

// The fog of the whole scene: density in 1/m, linear colour.
void set_fog(Scene& scene, float density, glm::vec3 color);

}  // namespace lamina
