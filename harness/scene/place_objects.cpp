// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/place_objects.h"

#include <glm/gtc/matrix_transform.hpp>

namespace lamina {

glm::mat4 Placement::applied(const glm::mat4& world_from_object) const {
  const glm::vec3 angles = glm::radians(rotation_degrees);
  glm::mat4 world = glm::translate(glm::mat4(1), position);
  for (int axis = 2; axis >= 0; --axis) {
    glm::vec3 about(0);
    about[axis] = 1;
    world = glm::rotate(world, angles[axis], about);
  }
  return glm::scale(world, scale) * world_from_object;
}

Placement read_placement(const TomlTable& table) {
  Placement place;
  place.position = table.optional_vec3("position").value_or(glm::vec3(0));
  place.rotation_degrees = table.optional_vec3("rotation_degrees").value_or(glm::vec3(0));
  if (!table.has("scale")) return place;
  place.scale = table.is_list("scale") ? table.vec3("scale") : glm::vec3(static_cast<float>(table.number("scale")));
  if (!(place.scale.x > 0 && place.scale.y > 0 && place.scale.z > 0))
    throw table.error("scale", "'scale' must be above 0 along every axis");
  return place;
}

}  // namespace lamina
