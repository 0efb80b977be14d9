// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/coloured_object.h"

#include "harness/scene/textures.h"

namespace lamina {

Object coloured_object(std::string name, Mesh mesh, glm::vec3 albedo, bool apertures) {
  Object object;
  object.albedo = constant_texture(name + " albedo", glm::vec4(albedo, 1), TexelMeaning::colour);
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  if (apertures) object.apertures = ApertureBake{};
  return object;
}

}  // namespace lamina
