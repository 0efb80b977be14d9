// SPDX-License-Identifier: Apache-2.0
// The device's clock, read between passes. A timestamp on a software rasterizer resolves near the end of the work recorded
// around it, so each is fenced off on both sides: full barrier, timestamp, full barrier (measured on lavapipe 22.3.6, where a
// barrier on one side alone gave all the time to the first of two passes).
#pragma once

#include <vulkan/vulkan.h>

#include <vector>

#include "harness/backend/vulkan/query_pool.h"

namespace lamina::vulkan {

class Timestamps {
 public:
  explicit Timestamps(Device& device) : device_(device), queries_(device, VK_QUERY_TYPE_TIMESTAMP, "timestamps") {}

  // Makes room for `count` marks. Throws Error(failed) where the device has no timestamps.
  void start(VkCommandBuffer commands, uint32_t count);
  // Full barrier and mark; the caller follows it with the second full barrier.
  void mark(VkCommandBuffer commands, uint32_t index) const;
  // Milliseconds between neighbouring marks, count - 1 of them. The device must be idle.
  std::vector<double> read_ms() const;

 private:
  Device& device_;
  QueryPool queries_;
  uint32_t count_ = 0;
};

}  // namespace lamina::vulkan
