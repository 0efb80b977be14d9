// SPDX-License-Identifier: Apache-2.0
// How many samples a pass has drawn, and how many fragments it has run shaders for: a query of each kind for each pass that
// asks, and none where no pass does.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <vector>

#include "harness/backend/vulkan/query_pool.h"

namespace lamina::vulkan {

class SampleCounts {
 public:
  explicit SampleCounts(Device& device)
      : device_(device),
        queries_(device, VK_QUERY_TYPE_OCCLUSION, "sample counts"),
        issued_(device, VK_QUERY_TYPE_PIPELINE_STATISTICS, "fragment counts",
                VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT) {}

  // Makes room for the passes. Throws Error(failed) where one asks for samples and the device only distinguishes some from
  // none.
  void start(VkCommandBuffer commands, std::span<const Pass> passes);
  // What the pass asks for, about its draws.
  void begin(VkCommandBuffer commands, const Pass& pass, uint32_t index) const;
  void end(VkCommandBuffer commands, const Pass& pass, uint32_t index) const;
  // RunTimes' counts. The device must be idle.
  void read(std::span<const Pass> passes, RunTimes& times) const;

 private:
  bool tells_issued() const { return device_.features().pipelineStatisticsQuery == VK_TRUE; }

  Device& device_;
  QueryPool queries_, issued_;
};

}  // namespace lamina::vulkan
