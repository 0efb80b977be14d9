// SPDX-License-Identifier: Apache-2.0
// A pipeline with the layout of its one descriptor set.
#pragma once

#include "harness/backend/vulkan/device.h"

namespace lamina::vulkan {

struct Pipeline {
  PipelineDesc desc;  // its stages without their words
  DescriptorSetLayoutHandle set_layout;
  PipelineLayoutHandle layout;
  PipelineHandle pipeline;
};

VkDescriptorType descriptor_type(BindingKind kind);

// Throws Error(bad_input) for a description that no device could take, Error(failed) where this device refuses it.
Pipeline make_pipeline(Device& device, const PipelineDesc& desc);

}  // namespace lamina::vulkan
