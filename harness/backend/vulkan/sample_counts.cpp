// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/sample_counts.h"

#include <algorithm>

namespace lamina::vulkan {
namespace {

using Asks = bool (*)(const Pass& pass);

// One for each pass, 0 where it does not ask; none where no pass does.
std::vector<uint64_t> results(const QueryPool& queries, std::span<const Pass> passes, Asks asks) {
  if (std::none_of(passes.begin(), passes.end(), asks)) return {};
  std::vector<uint64_t> counts(passes.size());
  for (uint32_t pass = 0; pass < passes.size(); ++pass)
    if (asks(passes[pass])) queries.read(pass, 1, &counts[pass]);
  return counts;
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
  times.samples = results(queries_, passes, counts_samples);
  if (tells_issued()) times.issued_fragments = results(issued_, passes, counts_issued_fragments);
}

}  // namespace lamina::vulkan
