// SPDX-License-Identifier: Apache-2.0
// How many samples a pass has drawn: one exact occlusion query for each pass that asks, and none where no pass does.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <vector>

#include "harness/backend/vulkan/query_pool.h"

namespace lamina::vulkan {

class SampleCounts {
 public:
  explicit SampleCounts(Device& device) : device_(device), queries_(device, VK_QUERY_TYPE_OCCLUSION, "sample counts") {}

  // Makes room for the passes. Throws Error(failed) where one asks and the device only distinguishes some from none.
  void start(VkCommandBuffer commands, std::span<const Pass> passes);
  void begin(VkCommandBuffer commands, uint32_t pass) const;
  void end(VkCommandBuffer commands, uint32_t pass) const;
  // As RunTimes::samples. The device must be idle.
  std::vector<uint64_t> read(std::span<const Pass> passes) const;

 private:
  Device& device_;
  QueryPool queries_;
};

}  // namespace lamina::vulkan
