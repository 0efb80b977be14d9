// SPDX-License-Identifier: Apache-2.0
// Host side of the uniform blocks in shaders/common/frame.glsl, std140: only vec4, ivec4 and mat4, so that C++ lays them out
// alike. tests/graph holds every name and offset against reflection.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "harness/scene/scene.h"

namespace lamina {

struct FrameUniforms {
  glm::mat4 clip_from_world;
  glm::vec4 eye_world;  // w = time in seconds
  glm::vec4 ambient;
  glm::vec4 frame_size_px;                           // width, height, 1/width, 1/height
  glm::ivec4 light_count;                            // x
  std::array<glm::vec4, max_lights> light_position;  // w = 1 point, 0 direction towards the light
  std::array<glm::vec4, max_lights> light_radiance;  // w = angular radius of a directional light, radius in metres of a point
};
static_assert(sizeof(FrameUniforms) == 64 + 4 * 16 + 2 * 16 * max_lights);

struct ObjectUniforms {
  glm::mat4 world_from_object;
  glm::mat4 world_from_object_normal;
  glm::vec4 layer;  // thickness in texels, scattering
};
static_assert(sizeof(ObjectUniforms) == 144);

struct PassUniforms {
  glm::ivec4 iteration;  // which, of how many
};

// The camera looks from eye to target; clip space as backend.h says.
FrameUniforms frame_uniforms(const Scene& scene, const View& view, uint32_t width_px, uint32_t height_px);
ObjectUniforms object_uniforms(const Object& object);

}  // namespace lamina
