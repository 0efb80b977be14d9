// SPDX-License-Identifier: Apache-2.0
// A scene of Embree's, and the device that holds it.
#pragma once

#include <embree3/rtcore.h>

#include <functional>
#include <span>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

struct EmbreeScene {
  // No ray slips through an edge that two triangles share; `flags`: what is asked for beside that. `stage` is named in errors.
  // Throws Error(failed) where Embree cannot be started.
  explicit EmbreeScene(const char* stage, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  struct Triangles {
    std::span<float> positions;   // three a vertex, in the world
    std::span<uint32_t> indices;  // three a triangle
  };
  // Room for the triangles of the scene's next geometry, filled by `fill`. Throws Error(failed) about `subject` where there is
  // no memory left.
  Triangles attach(size_t vertices, size_t triangles, const std::string& subject,
                   const std::function<void(const Triangles&)>& fill);
  // The object's triangles, in the world.
  Triangles attach(const Object& object);
  // Before the first ray. Throws Error(failed) where the hierarchy cannot be built.
  void commit();

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const char* stage;
};

}  // namespace lamina
