// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/coloured_object.h"

namespace lamina {

Object coloured_object(std::string name, Mesh mesh, glm::vec3 albedo, bool apertures) {
  Object object;
  object.said.values["albedo"] = {albedo};
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  if (apertures) object.said.calls.insert("aperture_lighting");
  return object;
}

}  // namespace lamina
