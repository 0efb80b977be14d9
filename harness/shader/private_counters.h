// SPDX-License-Identifier: Apache-2.0
// What one invocation of a shader counts before it ends: an array of its own, in memory. Variables of their own would each be
// merged at every branch and loop, and a shader with a hundred of them takes a driver minutes to compile.
#pragma once

#include "harness/shader/spirv_writer.h"

namespace lamina {

class PrivateCounters {
 public:
  // The writer must outlive this.
  explicit PrivateCounters(SpirvWriter& code) : code_(code) {}

  // As many counters, without values yet; not for none.
  void declare(uint32_t count);
  uint32_t count() const { return count_; }
  // All take and return ids of unsigned integers; `index` must be below the count. Into the writer's body.
  void set(uint32_t index, uint32_t value);
  void add(uint32_t index, uint32_t amount);
  uint32_t value(uint32_t index);

 private:
  uint32_t pointer_to(uint32_t index);

  SpirvWriter& code_;
  uint32_t count_ = 0, array_ = 0;
};

}  // namespace lamina
