// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/coloured_object.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/sphere_mesh.h"

namespace lamina {

Object coloured_object(std::string name, Mesh mesh, glm::vec3 albedo, bool apertures) {
  Object object;
  object.said.values["albedo"] = {albedo};
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  if (apertures) object.said.calls.insert("aperture_lighting");
  return object;
}

Object coloured_ball(std::string name, glm::vec3 middle, float radius, glm::vec3 albedo) {
  Object object = coloured_object(std::move(name), sphere_mesh(25), albedo, false);
  object.world_from_object = glm::scale(glm::translate(glm::mat4(1), middle), glm::vec3(radius));
  return object;
}

}  // namespace lamina
