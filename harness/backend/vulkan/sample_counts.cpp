// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/sample_counts.h"

#include <algorithm>

namespace lamina::vulkan {

void SampleCounts::start(VkCommandBuffer commands, std::span<const Pass> passes) {
  const auto asks = std::find_if(passes.begin(), passes.end(), counts_samples);
  if (asks == passes.end()) return;
  if (!device_.features().occlusionQueryPrecise)
    throw_failed(asks->name, fmt::format("{} does not count samples exactly", device_.info().device));
  queries_.reset(commands, static_cast<uint32_t>(passes.size()));
}

void SampleCounts::begin(VkCommandBuffer commands, uint32_t pass) const {
  vkCmdBeginQuery(commands, queries_.get(), pass, VK_QUERY_CONTROL_PRECISE_BIT);
}

void SampleCounts::end(VkCommandBuffer commands, uint32_t pass) const { vkCmdEndQuery(commands, queries_.get(), pass); }

std::vector<uint64_t> SampleCounts::read(std::span<const Pass> passes) const {
  if (std::none_of(passes.begin(), passes.end(), counts_samples)) return {};
  std::vector<uint64_t> samples(passes.size());
  for (uint32_t pass = 0; pass < passes.size(); ++pass)
    if (counts_samples(passes[pass])) queries_.read(pass, 1, &samples[pass]);
  return samples;
}

}  // namespace lamina::vulkan
