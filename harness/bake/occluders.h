// SPDX-License-Identifier: Apache-2.0
// Everything in a scene that can stand in light's way, as Intel's Embree casts rays at it. World space, metres; both sides of a
// triangle block.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

class Occluders {
 public:
  // Throws Error(failed) where Embree has no memory left.
  explicit Occluders(const Scene& scene);

  // Eight rays from one origin: rows of x, y and z of unit directions, and of how far each goes in metres. Bit i is set where
  // ray i meets nothing; bits of rays beyond `count` are 0.
  static constexpr size_t packet = 8;
  using Row = std::array<float, packet>;
  struct Packet {
    std::array<Row, 3> direction{};
    Row distance_m{};
  };
  uint32_t free_rays(glm::vec3 origin, const Packet& rays, size_t count = packet) const;

  // The cache key of all triangles; equal where every ray gives the same result in two scenes.
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
