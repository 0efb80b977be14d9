// SPDX-License-Identifier: Apache-2.0
// How many samples a pass has drawn, and how many fragments it has run shaders for: a query of each kind for each pass that
// asks, and none where no pass does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/backend/opengl/object.h"

namespace lamina::gl {

class SampleCounts {
 public:
  // `tells_issued`: whether the device counts the fragments that it runs shaders for.
  explicit SampleCounts(bool tells_issued) : tells_issued_(tells_issued) {}

  // Makes the queries that the passes need. Throws Error(failed) where one asks for samples and the device does not count.
  void prepare(std::span<const Pass> passes);
  // What the pass asks for, about its draws.
  void begin(const Pass& pass, size_t index) const;
  void end(const Pass& pass) const;
  // RunTimes' counts. Waits for the device: call it after the frame.
  void read(std::span<const Pass> passes, RunTimes& times) const;

 private:
  bool tells_issued_;
  std::vector<QueryObject> queries_, issued_;
};

}  // namespace lamina::gl
