// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/sample_counts.h"

#include <algorithm>

namespace lamina::vulkan {

void SampleCounts::start(VkCommandBuffer commands, std::span<const Pass> passes) {
  const auto asks = std::find_if(passes.begin(), passes.end(), counts_samples);
  if (asks == passes.end()) return;
  if (!device_.features().occlusionQueryPrecise)
    throw_failed(asks->name, fmt::format("{} does not count samples exactly", device_.info().device));
  const auto count = static_cast<uint32_t>(passes.size());
  if (capacity_ < count) {
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_OCCLUSION;
    info.queryCount = std::max(count, 2 * capacity_);
    VkQueryPool pool = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device_.get(), &info, nullptr, &pool), "sample counts", "vkCreateQueryPool");
    pool_ = device_.own<QueryPoolHandle>(pool, "lamina sample counts");
    capacity_ = info.queryCount;
  }
  vkCmdResetQueryPool(commands, pool_.get(), 0, count);
}

void SampleCounts::begin(VkCommandBuffer commands, uint32_t pass) const {
  vkCmdBeginQuery(commands, pool_.get(), pass, VK_QUERY_CONTROL_PRECISE_BIT);
}

void SampleCounts::end(VkCommandBuffer commands, uint32_t pass) const { vkCmdEndQuery(commands, pool_.get(), pass); }

std::vector<uint64_t> SampleCounts::read(std::span<const Pass> passes) const {
  if (std::none_of(passes.begin(), passes.end(), counts_samples)) return {};
  std::vector<uint64_t> samples(passes.size());
  for (uint32_t pass = 0; pass < passes.size(); ++pass)
    if (counts_samples(passes[pass]))
      check(vkGetQueryPoolResults(device_.get(), pool_.get(), pass, 1, sizeof(uint64_t), &samples[pass], sizeof(uint64_t),
                                  VK_QUERY_RESULT_64_BIT),
            "sample counts", "vkGetQueryPoolResults");
  return samples;
}

}  // namespace lamina::vulkan
