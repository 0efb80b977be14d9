// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/fog_hull.h"

#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/sphere_mesh.h"

namespace lamina {

Object fog_hull(std::string name, Mesh mesh, const glm::mat4& world_from_object, float share, bool hole) {
  Object object;
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  object.world_from_object = world_from_object;
  object.said.calls.insert("volume_fog");
  object.said.values["fog.share"] = {double(share)};
  object.said.values["fog.volume"] = {std::string(hole ? "hole" : "fog")};
  return object;
}

Object fog_ball(std::string name, glm::vec3 centre, glm::vec3 radii, float share, float turn_degrees) {
  static const Mesh sphere = sphere_mesh(25);
  const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1), centre), glm::radians(turn_degrees), glm::vec3(0, 1, 0));
  return fog_hull(std::move(name), sphere, glm::scale(turned, radii), share);
}

Object fog_box(std::string name, glm::vec3 low, glm::vec3 high, float share, bool hole) {
  const float whole = glm::length(high - low);
  return fog_hull(std::move(name), block_mesh({{low, high}}, whole), glm::mat4(1), share, hole);
}

void set_fog(Scene& scene, float density, glm::vec3 color) {
  Keys& said = scene.said["volume_fog"];
  said.values["density"] = {double(density)};
  said.values["color"] = {color};
}

}  // namespace lamina
