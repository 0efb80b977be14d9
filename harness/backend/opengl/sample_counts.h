// SPDX-License-Identifier: Apache-2.0
// How many samples a pass has drawn: one query for each pass that asks, and none where no pass does.
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
  // Makes the queries that the passes need. Throws Error(failed) where one asks and the device does not count.
  void prepare(std::span<const Pass> passes);
  void begin(size_t pass) const { glBeginQuery(GL_SAMPLES_PASSED, queries_[pass].name()); }
  void end() const { glEndQuery(GL_SAMPLES_PASSED); }
  // As RunTimes::samples. Waits for the device: call it after the frame.
  std::vector<uint64_t> read(std::span<const Pass> passes) const;

 private:
  std::vector<QueryObject> queries_;
};

}  // namespace lamina::gl
