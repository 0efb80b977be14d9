// SPDX-License-Identifier: Apache-2.0
// Queries of one type, as many as the largest frame so far needed.
#pragma once

#include <vulkan/vulkan.h>

#include <vector>

#include "harness/backend/vulkan/device.h"

namespace lamina::vulkan {

class QueryPool {
 public:
  // `name` stands in messages and is the pool's debug name.
  // `statistic`: the one that queries of VK_QUERY_TYPE_PIPELINE_STATISTICS count.
  QueryPool(Device& device, VkQueryType type, const char* name, VkQueryPipelineStatisticFlags statistic = 0)
      : device_(device), type_(type), name_(name), statistic_(statistic) {}

  VkQueryPool get() const { return pool_.get(); }
  // Makes room for `count` queries and resets them as the first of the commands.
  void reset(VkCommandBuffer commands, uint32_t count);
  // The results of `count` queries from `first` on. The device must be idle.
  void read(uint32_t first, uint32_t count, uint64_t* results) const;

 private:
  Device& device_;
  VkQueryType type_;
  const char* name_;
  VkQueryPipelineStatisticFlags statistic_;
  QueryPoolHandle pool_;
  uint32_t capacity_ = 0;
};

}  // namespace lamina::vulkan
