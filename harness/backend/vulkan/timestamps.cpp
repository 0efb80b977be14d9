// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/timestamps.h"

namespace lamina::vulkan {

void Timestamps::start(VkCommandBuffer commands, uint32_t count) {
  if (device_.timestamp_bits() == 0)
    throw_failed(device_.info().device, "its queue has no timestamps, so its passes cannot be timed");
  count_ = count;
  queries_.reset(commands, count);
}

void Timestamps::mark(VkCommandBuffer commands, uint32_t index) const {
  full_barrier(commands);
  vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), index);
}

std::vector<double> Timestamps::read_ms() const {
  std::vector<uint64_t> ticks(count_);
  queries_.read(0, count_, ticks.data());
  // The counter wraps at its valid bits; so does the difference.
  const uint32_t bits = device_.timestamp_bits();
  const uint64_t mask = bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
  constexpr double ms_per_ns = 1e-6;
  const double ms_per_tick = static_cast<double>(device_.limits().timestampPeriod) * ms_per_ns;
  std::vector<double> times_ms;
  for (size_t i = 0; i + 1 < ticks.size(); ++i)
    times_ms.push_back(static_cast<double>((ticks[i + 1] - ticks[i]) & mask) * ms_per_tick);
  return times_ms;
}

}  // namespace lamina::vulkan
