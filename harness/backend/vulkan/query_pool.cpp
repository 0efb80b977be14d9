// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/query_pool.h"

#include <algorithm>

namespace lamina::vulkan {

void QueryPool::reset(VkCommandBuffer commands, uint32_t count) {
  if (capacity_ < count) {
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = type_;
    info.pipelineStatistics = statistic_;
    info.queryCount = std::max(count, 2 * capacity_);
    VkQueryPool pool = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device_.get(), &info, nullptr, &pool), name_, "vkCreateQueryPool");
    pool_ = device_.own<QueryPoolHandle>(pool, std::string("lamina ") + name_);
    capacity_ = info.queryCount;
  }
  vkCmdResetQueryPool(commands, pool_.get(), 0, count);
}

void QueryPool::read(uint32_t first, uint32_t count, uint64_t* results) const {
  check(vkGetQueryPoolResults(device_.get(), pool_.get(), first, count, count * sizeof(uint64_t), results, sizeof(uint64_t),
                              VK_QUERY_RESULT_64_BIT),
        name_, "vkGetQueryPoolResults");
}

}  // namespace lamina::vulkan
