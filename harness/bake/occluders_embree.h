// SPDX-License-Identifier: Apache-2.0
// Embree's side of Occluders, for those who call Embree themselves (its benchmark, truths).
#pragma once

#include <embree3/rtcore.h>

#include <span>

#include "harness/bake/occluders.h"

namespace lamina {

struct Occluders::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

// What Embree holds of an object, in the world: three numbers a vertex, three indices a triangle.
struct EmbreeTriangles {
  std::span<const float> positions;
  std::span<const uint32_t> indices;
};
// Gives the object's triangles to the scene, whose next geometry they are. Throws Error(failed, stage, ...) where there is no
// memory left.
EmbreeTriangles attach_triangles(RTCDevice device, RTCScene scene, const Object& object, const char* stage);

}  // namespace lamina
