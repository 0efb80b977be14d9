// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/sample_counts.h"

#include <algorithm>

#include "harness/backend/common/pass_counts.h"

namespace lamina::vulkan {
namespace {

uint64_t result_of(const QueryPool& queries, size_t pass) {
  uint64_t count = 0;
  queries.read(static_cast<uint32_t>(pass), 1, &count);
  return count;
}

}  // namespace

void SampleCounts::start(VkCommandBuffer commands, std::span<const Pass> passes) {
  const auto count = static_cast<uint32_t>(passes.size());
  if (const auto asks = std::find_if(passes.begin(), passes.end(), counts_samples); asks != passes.end()) {
    if (!device_.features().occlusionQueryPrecise)
      throw_failed(asks->name, fmt::format("{} does not count samples exactly", device_.info().device));
    queries_.reset(commands, count);
  }
  if (tells_issued() && std::any_of(passes.begin(), passes.end(), counts_issued_fragments)) issued_.reset(commands, count);
}

void SampleCounts::begin(VkCommandBuffer commands, const Pass& pass, uint32_t index) const {
  if (counts_samples(pass)) vkCmdBeginQuery(commands, queries_.get(), index, VK_QUERY_CONTROL_PRECISE_BIT);
  if (counts_issued_fragments(pass) && tells_issued()) vkCmdBeginQuery(commands, issued_.get(), index, 0);
}

void SampleCounts::end(VkCommandBuffer commands, const Pass& pass, uint32_t index) const {
  if (counts_issued_fragments(pass) && tells_issued()) vkCmdEndQuery(commands, issued_.get(), index);
  if (counts_samples(pass)) vkCmdEndQuery(commands, queries_.get(), index);
}

void SampleCounts::read(std::span<const Pass> passes, RunTimes& times) const {
  times.samples = counts_of(passes, counts_samples, [&](size_t pass) { return result_of(queries_, pass); });
  if (!tells_issued()) return;
  times.issued_fragments = counts_of(passes, counts_issued_fragments, [&](size_t pass) { return result_of(issued_, pass); });
}

}  // namespace lamina::vulkan
