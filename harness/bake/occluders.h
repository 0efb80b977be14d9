// SPDX-License-Identifier: Apache-2.0
// Everything in a scene that can stand in light's way, as Intel's Embree casts rays at it. World space, metres; both sides of a
// triangle block.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

class Occluders {
 public:
  // Throws Error(failed) where Embree has no memory left.
  explicit Occluders(const Scene& scene);

  // Eight rays from one origin, directions as three rows of x, y and z (any length above 0). Bit i is set where ray i meets
  // nothing; bits of rays beyond `count` are 0.
  static constexpr size_t packet = 8;
  using Packet = std::array<std::array<float, packet>, 3>;
  uint32_t free_rays(glm::vec3 origin, const Packet& directions, size_t count = packet) const;
  // One ray, up to `distance_m` along a unit direction.
  bool is_free(glm::vec3 origin, glm::vec3 direction, float distance_m = std::numeric_limits<float>::infinity()) const;

  // Of all triangles; equal where no ray can tell two scenes apart.
  const std::string& hash() const { return hash_; }
  // How far rays start above a surface where nothing else is asked for: a ten-thousandth of the scene's radius.
  float default_bias_m() const { return default_bias_m_; }

  struct Handles;  // Embree's
  const Handles& handles() const { return *handles_; }

 private:
  std::shared_ptr<const Handles> handles_;
  std::string hash_;
  float default_bias_m_ = 0;
};

}  // namespace lamina
