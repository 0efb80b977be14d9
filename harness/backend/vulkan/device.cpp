// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/device.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "harness/core/stopwatch.h"

namespace lamina::vulkan {
namespace {

// Index of the first memory type among `allowed` (a bit each) that has all of `wanted`, or nothing.
std::optional<uint32_t> find_memory_type(const VkPhysicalDeviceMemoryProperties& memory, uint32_t allowed,
                                         VkMemoryPropertyFlags wanted) {
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((allowed >> i & 1) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
  return std::nullopt;
}

std::optional<uint32_t> find_memory_type(const VkPhysicalDeviceMemoryProperties& memory, uint32_t allowed, MemoryUse use) {
  constexpr VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  if (use == MemoryUse::host) {
    // Cached where it can be: read-back from uncached memory crawls on real GPUs.
    const auto cached = find_memory_type(memory, allowed, mapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
    return cached ? cached : find_memory_type(memory, allowed, mapped);
  }
  const auto own = find_memory_type(memory, allowed, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  return own ? own : find_memory_type(memory, allowed, 0);
}

}  // namespace

Device::Device(const Instance& instance, const Candidate& candidate) : candidate_(candidate) {
  vkGetPhysicalDeviceMemoryProperties(candidate_.handle, &memory_);

  constexpr float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = candidate_.queue_family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;

  VkPhysicalDeviceFeatures offered{};
  vkGetPhysicalDeviceFeatures(candidate_.handle, &offered);
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  features13.maintenance4 = VK_TRUE;  // every 1.3 device has it: a fragment shader may ignore what the vertex shader hands on
  features_.vertexPipelineStoresAndAtomics = VK_TRUE;
  features_.fragmentStoresAndAtomics = VK_TRUE;
  // What passes ask for where the device has it.
  features_.independentBlend = offered.independentBlend;
  features_.occlusionQueryPrecise = offered.occlusionQueryPrecise;
  features_.pipelineStatisticsQuery = offered.pipelineStatisticsQuery;
  // What users' shaders may use where the device has it.
  features_.shaderStorageImageExtendedFormats = offered.shaderStorageImageExtendedFormats;
  features_.shaderStorageImageReadWithoutFormat = offered.shaderStorageImageReadWithoutFormat;
  features_.shaderStorageImageWriteWithoutFormat = offered.shaderStorageImageWriteWithoutFormat;
  features_.shaderFloat64 = offered.shaderFloat64;
  features_.shaderInt64 = offered.shaderInt64;
  VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &features13};
  features12.shaderFloat16 = candidate_.info.half_floats;
  const VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features12, features_};

  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  const VkResult created = vkCreateDevice(candidate_.handle, &info, nullptr, &device_.handle);
  if (created != VK_SUCCESS)
    throw Error(ErrorKind::no_device, "vulkan", candidate_.info.device, fmt::format("vkCreateDevice: {}", describe(created)));
  vkGetDeviceQueue(get(), candidate_.queue_family, 0, &queue_);

  if (instance.can_name_objects()) {
    const auto load = [&](const char* name) { return vkGetInstanceProcAddr(instance.get(), name); };
    set_object_name_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(load("vkSetDebugUtilsObjectNameEXT"));
    begin_label_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(load("vkCmdBeginDebugUtilsLabelEXT"));
    end_label_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(load("vkCmdEndDebugUtilsLabelEXT"));
  }
  set_name(VK_OBJECT_TYPE_DEVICE, reinterpret_cast<uint64_t>(get()), "lamina device");
  set_name(VK_OBJECT_TYPE_QUEUE, reinterpret_cast<uint64_t>(queue_), "lamina queue");

  VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool_info.queueFamilyIndex = candidate_.queue_family;
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(get(), &pool_info, nullptr, &pool), candidate_.info.device, "vkCreateCommandPool");
  pool_ = own<CommandPoolHandle>(pool, "lamina command pool");

  VkCommandBufferAllocateInfo buffer_info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  buffer_info.commandPool = pool;
  buffer_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer_info.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(get(), &buffer_info, &commands_), candidate_.info.device, "vkAllocateCommandBuffers");
  set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(commands_), "lamina commands");

  const VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  check(vkCreateFence(get(), &fence_info, nullptr, &fence), candidate_.info.device, "vkCreateFence");
  fence_ = own<FenceHandle>(fence, "lamina frame done");
}

Device::Root::~Root() {
  if (handle != VK_NULL_HANDLE) vkDestroyDevice(handle, nullptr);
}

Device::~Device() { vkDeviceWaitIdle(get()); }

bool Device::supports(VkFormat format, VkFormatFeatureFlags features) const {
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(candidate_.handle, format, &properties);
  return (properties.optimalTilingFeatures & features) == features;
}

MemoryHandle Device::allocate(const VkMemoryRequirements& needed, MemoryUse use, const std::string& subject) {
  const std::optional<uint32_t> type = find_memory_type(memory_, needed.memoryTypeBits, use);
  if (!type) throw_failed(subject, "the device has no memory of the kind that this needs");
  const VkDeviceSize heap_bytes = memory_.memoryHeaps[memory_.memoryTypes[*type].heapIndex].size;
  const VkDeviceSize limit_bytes = std::min(candidate_.max_allocation_bytes, heap_bytes);
  if (needed.size > limit_bytes)
    throw_failed(subject, fmt::format("it takes {} bytes and the device gives at most {} at once; use a smaller size",
                                      needed.size, limit_bytes));
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needed.size;
  info.memoryTypeIndex = *type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(get(), &info, nullptr, &memory), subject, "vkAllocateMemory");
  return own<MemoryHandle>(memory, subject + " memory");
}

VkCommandBuffer Device::begin() {
  check(vkResetCommandPool(get(), pool_.get(), 0), candidate_.info.device, "vkResetCommandPool");
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &info), candidate_.info.device, "vkBeginCommandBuffer");
  return commands_;
}

double Device::submit_and_wait(VkCommandBuffer commands) {
  check(vkEndCommandBuffer(commands), candidate_.info.device, "vkEndCommandBuffer");
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &buffer;
  const VkFence fence = fence_.get();
  check(vkResetFences(get(), 1, &fence), candidate_.info.device, "vkResetFences");
  const Stopwatch watch;
  check(vkQueueSubmit2(queue_, 1, &submit, fence), candidate_.info.device, "vkQueueSubmit2");
  check(vkWaitForFences(get(), 1, &fence, VK_TRUE, std::numeric_limits<uint64_t>::max()), candidate_.info.device,
        "vkWaitForFences");
  return watch.elapsed_ms();
}

void Device::begin_label(VkCommandBuffer commands, const std::string& name) const {
  if (begin_label_ == nullptr) return;
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = name.c_str();
  begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
  if (end_label_ != nullptr) end_label_(commands);
}

void Device::set_name(VkObjectType type, uint64_t object, const std::string& name) const {
  if (set_object_name_ == nullptr) return;
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = object;
  info.pObjectName = name.c_str();
  set_object_name_(get(), &info);
}

void full_barrier(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> transitions) {
  constexpr VkPipelineStageFlags2 everything = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
  VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  memory.srcStageMask = everything;
  memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  memory.dstStageMask = everything;
  memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &memory;
  info.imageMemoryBarrierCount = static_cast<uint32_t>(transitions.size());
  info.pImageMemoryBarriers = transitions.data();
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace lamina::vulkan
