// SPDX-License-Identifier: Apache-2.0
// Embree's side of Occluders, for those who call Embree themselves (its benchmark).
#pragma once

#include <embree3/rtcore.h>

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

}  // namespace lamina
