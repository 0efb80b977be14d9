// SPDX-License-Identifier: Apache-2.0
// The one owner of Vulkan objects that belong to a device: move-only, destroys what it holds.
#pragma once

#include <vulkan/vulkan.h>

#include <utility>

namespace lamina::vulkan {

template <class T, VkObjectType object_type, void (*destroy)(VkDevice, T, const VkAllocationCallbacks*)>
class Handle {
 public:
  static constexpr VkObjectType type = object_type;

  Handle() = default;
  Handle(VkDevice device, T object) : device_(device), object_(object) {}
  Handle(Handle&& other) noexcept : device_(other.device_), object_(std::exchange(other.object_, T{})) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(object_, other.object_);
    return *this;
  }
  ~Handle() {
    if (object_ != T{}) destroy(device_, object_, nullptr);
  }

  T get() const { return object_; }
  explicit operator bool() const { return object_ != T{}; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  T object_{};
};

using BufferHandle = Handle<VkBuffer, VK_OBJECT_TYPE_BUFFER, vkDestroyBuffer>;
using CommandPoolHandle = Handle<VkCommandPool, VK_OBJECT_TYPE_COMMAND_POOL, vkDestroyCommandPool>;
using DescriptorPoolHandle = Handle<VkDescriptorPool, VK_OBJECT_TYPE_DESCRIPTOR_POOL, vkDestroyDescriptorPool>;
using DescriptorSetLayoutHandle =
    Handle<VkDescriptorSetLayout, VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, vkDestroyDescriptorSetLayout>;
using FenceHandle = Handle<VkFence, VK_OBJECT_TYPE_FENCE, vkDestroyFence>;
using ImageHandle = Handle<VkImage, VK_OBJECT_TYPE_IMAGE, vkDestroyImage>;
using ImageViewHandle = Handle<VkImageView, VK_OBJECT_TYPE_IMAGE_VIEW, vkDestroyImageView>;
using MemoryHandle = Handle<VkDeviceMemory, VK_OBJECT_TYPE_DEVICE_MEMORY, vkFreeMemory>;
using PipelineHandle = Handle<VkPipeline, VK_OBJECT_TYPE_PIPELINE, vkDestroyPipeline>;
using PipelineLayoutHandle = Handle<VkPipelineLayout, VK_OBJECT_TYPE_PIPELINE_LAYOUT, vkDestroyPipelineLayout>;
using QueryPoolHandle = Handle<VkQueryPool, VK_OBJECT_TYPE_QUERY_POOL, vkDestroyQueryPool>;
using SamplerHandle = Handle<VkSampler, VK_OBJECT_TYPE_SAMPLER, vkDestroySampler>;
using ShaderModuleHandle = Handle<VkShaderModule, VK_OBJECT_TYPE_SHADER_MODULE, vkDestroyShaderModule>;

}  // namespace lamina::vulkan
