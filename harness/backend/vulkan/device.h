// SPDX-License-Identifier: Apache-2.0
// The logical device: its queue, its memory, its names for objects, and one command buffer that is submitted and waited for.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <string>
#include <string_view>

#include "harness/backend/vulkan/handle.h"
#include "harness/backend/vulkan/instance.h"
#include "harness/backend/vulkan/result.h"

namespace lamina::vulkan {

enum class MemoryUse {
  device,  // the device's own; the host reaches it through staging
  host,    // mapped and coherent, for what the host writes every frame and for staging
};

class Device {
 public:
  // Throws Error(no_device) where the driver refuses.
  Device(const Instance& instance, const Candidate& candidate);
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device();

  VkDevice get() const { return device_.handle; }
  VkPhysicalDevice physical() const { return candidate_.handle; }
  const DeviceInfo& info() const { return candidate_.info; }
  const VkPhysicalDeviceLimits& limits() const { return candidate_.properties.limits; }
  uint32_t timestamp_bits() const { return candidate_.info.timestamp_bits; }
  const VkPhysicalDeviceFeatures& features() const { return features_; }  // those that are switched on

  // True where optimally tiled images of `format` can do all of `features`.
  bool supports(VkFormat format, VkFormatFeatureFlags features) const;

  // The most bytes that one allocation of such memory may have; 0 where there is none.
  VkDeviceSize most_at_once(const VkMemoryRequirements& needed, MemoryUse use) const;
  // Throws Error(failed) naming `subject` where the memory has no room.
  MemoryHandle allocate(const VkMemoryRequirements& needed, MemoryUse use, const std::string& subject);

  // Takes ownership of a new object and names it for debuggers and the validation layers.
  template <class Owner, class T>
  Owner own(T object, const std::string& name) {
    Owner owner(get(), object);
    set_name(Owner::type, reinterpret_cast<uint64_t>(object), name);
    return owner;
  }

  // The one command buffer. begin() discards what it held; submit_and_wait() returns when the device is idle, with the host's
  // milliseconds from submission to there.
  VkCommandBuffer begin();
  double submit_and_wait(VkCommandBuffer commands);

  // Names a stretch of commands for debuggers.
  void begin_label(VkCommandBuffer commands, const std::string& name) const;
  void end_label(VkCommandBuffer commands) const;

 private:
  struct Root {  // destroyed after every member that lives on the device
    VkDevice handle = VK_NULL_HANDLE;
    Root() = default;
    Root(const Root&) = delete;
    Root& operator=(const Root&) = delete;
    ~Root();
  };
  void set_name(VkObjectType type, uint64_t object, const std::string& name) const;

  Candidate candidate_;
  VkPhysicalDeviceFeatures features_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  Root device_;
  VkQueue queue_ = VK_NULL_HANDLE;
  CommandPoolHandle pool_;
  FenceHandle fence_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  PFN_vkSetDebugUtilsObjectNameEXT set_object_name_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

// Everything after waits for everything before and sees what it wrote, the host included; `transitions` happen between.
void full_barrier(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> transitions = {});

}  // namespace lamina::vulkan
