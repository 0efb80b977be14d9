// SPDX-License-Identifier: Apache-2.0
// Light that has diffused through skin to one point of its surface: see skin_truth.h.
#pragma once

#include "harness/effects/skin/skin_surface.h"

namespace lamina {

struct DiffusedLight {
  glm::dvec3 same_side{0};  // from where the surface faces the same half of space
  glm::dvec3 all{0};
};
// Times the root of the albedo where light enters. `lines`: 12 or more; `seed`: another one shifts all of them.
DiffusedLight diffused_light(const SkinSurface& surface, glm::dvec3 position, glm::dvec3 normal, size_t lines, uint64_t seed);

}  // namespace lamina
