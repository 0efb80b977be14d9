// SPDX-License-Identifier: Apache-2.0
// Device time of passes, the way that software rasterizers need it. llvmpipe resolves a timestamp only with the drawing that is
// queued beside it, so each timestamp stands alone between two glFinish; GL_TIME_ELAPSED is wrong there by construction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "harness/backend/opengl/object.h"

namespace lamina::gl {

class PassTimer {
 public:
  // Makes the queries that `passes` need. Throws Error(failed) where the device has no timestamps.
  void prepare(size_t passes);
  void begin(size_t pass) { stamp(2 * pass); }
  void end(size_t pass) { stamp(2 * pass + 1); }
  // Milliseconds of each of the first `passes` passes. Waits for the device: call it after the frame.
  std::vector<double> read_ms(size_t passes) const;

 private:
  void stamp(size_t query) const;

  std::vector<QueryObject> queries_;
  uint64_t mask_ = 0;  // the bits that the device's counter has
};

}  // namespace lamina::gl
