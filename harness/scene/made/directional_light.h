// SPDX-License-Identifier: Apache-2.0
// A light from afar, as scenes made by code use them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// `to_light`: unit. `radiance` and `angular_radius` as in Light.
inline Light directional_light(std::string name, glm::vec3 to_light, glm::vec3 radiance, float angular_radius = 0) {
  Light light;
  light.name = std::move(name);
  light.direction = -to_light;
  light.radiance = radiance;
  light.angular_radius = angular_radius;
  return light;
}

}  // namespace lamina
