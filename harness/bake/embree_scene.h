// SPDX-License-Identifier: Apache-2.0
// A scene of Embree's, and the device that holds it.
#pragma once

#include <embree3/rtcore.h>

#include <compare>
#include <functional>
#include <span>
#include <string>
#include <vector>

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

  // A ray without end. The direction is unit where distances are to be metres.
  static RTCRayHit ray_from(glm::dvec3 origin, glm::dvec3 direction);
  // The first triangle that the ray meets; its geometry is RTC_INVALID_GEOMETRY_ID where it meets none. `filter`, for which the
  // scene needs RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION, may let the ray go on.
  RTCRayHit first_hit(glm::dvec3 origin, glm::dvec3 direction, RTCFilterFunctionN filter = nullptr) const;
  struct TriangleId {
    unsigned geometry, triangle;
    auto operator<=>(const TriangleId&) const = default;
  };
  // Every triangle that the ray meets, once, in ascending order; beside an edge also one that it only just misses. Needs
  // RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION.
  std::vector<TriangleId> triangles_along(glm::dvec3 origin, glm::dvec3 direction) const;

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const char* stage;
};

}  // namespace lamina
