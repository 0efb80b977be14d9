// SPDX-License-Identifier: Apache-2.0
// A truth computes an offline picture of exactly the points that the device drew: passes with when = "truth" write these
// points, pixel by pixel. It also computes the picture with one assumption of the effect at a time, so that each assumption's
// share of the error is known. Effects bring truths by name: see harness/manifest/effect_code.h.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "harness/bake/occluders.h"
#include "harness/core/disk_cache.h"
#include "harness/core/image.h"
#include "harness/manifest/effect_code.h"
#include "harness/scene/scene.h"

namespace lamina {

// What a truth may use; all of it outlives the truth.
struct TruthSetting {
  const Scene& scene;
  const Occluders& occluders;
  DiskCache& cache;
  size_t rays = 256;  // a point and light, or whatever the truth samples
};

// What the truth passes of a variant left for a view.
struct Told {
  const std::map<std::string, Image>& targets;  // by name: those of four floats that are as large as the frame
  const View& view;
  const BakeOptions& bake;  // the variant's

  // Throws Error(bad_input) where there is none; `truth` is the name of who asks.
  const Image& target(const std::string& name, const std::string& truth) const;
};

struct TruthStep {
  std::string name, title;       // of the assumption that the step before makes and this one does not
  std::vector<glm::vec3> light;  // linear, beside TruthAnswer::pixels
};
struct TruthAnswer {
  std::vector<size_t> pixels;  // row * width + column, of those that are answered for
  // Begins after the variant's own picture; each step drops one assumption; the last is the truth. The first assumption is the
  // variant's own. The others are shared by all variants whose truth passes show the same points.
  std::vector<TruthStep> steps;
};

class Truth {
 public:
  virtual ~Truth() = default;
  // Empty where the view shows nothing of the effect. `progress`: 0 to 1.
  virtual TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) = 0;
  // What was kept of the last view may go.
  virtual void view_changed() {}
  // What was kept of the scene's numbers, and of its last view, may go.
  virtual void scene_changed() { view_changed(); }
};

}  // namespace lamina
