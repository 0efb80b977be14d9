// SPDX-License-Identifier: Apache-2.0
#include "harness/graph/uniforms.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace lamina {

FrameUniforms frame_uniforms(const Scene& scene, const View& view, uint32_t width_px, uint32_t height_px) {
  FrameUniforms uniforms{};
  const float width = static_cast<float>(width_px), height = static_cast<float>(height_px);
  glm::mat4 clip_from_view = glm::perspectiveRH_ZO(glm::radians(view.fov_y_degrees), width / height, view.near_m, view.far_m);
  clip_from_view[1] *= -1.0f;  // GLM's y runs up, ours down
  uniforms.clip_from_world = clip_from_view * glm::lookAtRH(view.eye, view.target, view.up);
  uniforms.eye_world = glm::vec4(view.eye, scene.time_s);
  uniforms.ambient = glm::vec4(scene.ambient, 0);
  uniforms.frame_size_px = {width, height, 1 / width, 1 / height};
  uniforms.light_count.x = static_cast<int>(std::min(scene.lights.size(), max_lights));
  for (size_t i = 0; i < static_cast<size_t>(uniforms.light_count.x); ++i) {
    const Light& light = scene.lights[i];
    const bool point = light.kind == Light::Kind::point;
    uniforms.light_position[i] = point ? glm::vec4(light.position, 1) : glm::vec4(-light.direction, 0);
    uniforms.light_radiance[i] = glm::vec4(light.radiance, point ? light.radius_m : light.angular_radius);
  }
  return uniforms;
}

ObjectUniforms object_uniforms(const Object& object) {
  ObjectUniforms uniforms{};
  uniforms.world_from_object = object.world_from_object;
  uniforms.world_from_object_normal = glm::mat4(glm::transpose(glm::inverse(glm::mat3(object.world_from_object))));
  if (object.layers) uniforms.layer = {object.layers->thickness_texels, object.layers->scattering, 0, 0};
  return uniforms;
}

}  // namespace lamina
