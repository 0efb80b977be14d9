// SPDX-License-Identifier: Apache-2.0
// A scene on a device, and how it goes from point to point of a sweep.
#pragma once

#include <functional>
#include <memory>

#include "harness/cli/options.h"
#include "harness/graph/scene_resources.h"
#include "harness/plan/plan.h"
#include "harness/sweep/swept_scene.h"

namespace lamina {

// All that passes are made of, but shaders. Whoever made it owns it.
struct SceneOnDevice {
  const Scene* scene = nullptr;
  const Plan* plan = nullptr;
  Bakes* bakes = nullptr;
  SceneResources* resources = nullptr;
};

// A swept scene at one point after another. What a point does not touch stays on the device.
class SweptSceneOnDevice {
 public:
  // Everything must outlive this. Puts nothing on the device yet.
  SweptSceneOnDevice(Backend& backend, SweptScene& scenes, const Library& library, const CellOptions& options);

  // Where textures or meshes must be made anew, calls `release` first: whoever binds the old ones must let go of them. What it
  // throws is of this point; the next one is made anew.
  void go_to(size_t point, const std::function<void()>& release);
  SceneOnDevice here() { return {&scene_, &plan_, bakes_.get(), resources_.get()}; }

 private:
  Backend& backend_;
  SweptScene& scenes_;
  const Library& library_;
  const CellOptions& options_;
  Scene scene_;  // at the point
  Plan plan_;
  std::string device_digest_, meshes_digest_;
  std::unique_ptr<Bakes> bakes_;
  std::unique_ptr<SceneResources> resources_;
};

}  // namespace lamina
