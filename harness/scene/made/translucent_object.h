// SPDX-License-Identifier: Apache-2.0
// An object that lets light through, as scenes made by code use them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

struct TranslucentMedium {
  glm::vec3 extinction{40, 70, 120};      // 1/m
  glm::vec3 albedo{0.92f, 0.85f, 0.75f};  // scattering over extinction, 0 to 1
  double refraction_index = 1.4;
  double thickness_m = 0.05;  // what an artist would give for all of it
};

Object translucent_object(std::string name, Mesh mesh, const TranslucentMedium& medium);

}  // namespace lamina
