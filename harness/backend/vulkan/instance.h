// SPDX-License-Identifier: Apache-2.0
// The connection to Vulkan's loader, its checker's messages, and the devices that can run Lamina.
#pragma once

#include <vulkan/vulkan.h>

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina::vulkan {

// What the validation layers said; they may speak from the driver's threads.
class MessageList {
 public:
  void add(std::string message);
  std::vector<std::string> take();

 private:
  std::mutex mutex_;
  std::vector<std::string> messages_;
};

class Instance {
 public:
  // Throws Error(no_device) where there is no Vulkan 1.3 loader, no driver, or no validation layer when it is asked for.
  explicit Instance(bool validation);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance();

  VkInstance get() const { return instance_; }
  bool can_name_objects() const { return debug_utils_; }
  std::vector<std::string> take_messages() { return messages_.take(); }

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  bool debug_utils_ = false;
  MessageList messages_;
};

// A device with all that Lamina needs: Vulkan 1.3, dynamic rendering, synchronization2, storage writes from the vertex and
// fragment stages, and one queue family for drawing and computing.
struct Candidate {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  DeviceInfo info;
  VkPhysicalDeviceProperties properties{};
  VkDeviceSize max_allocation_bytes = 0;
  uint32_t queue_family = 0;
};
// `refused` gets the others.
std::vector<Candidate> find_candidates(const Instance& instance, std::vector<RefusedDevice>* refused = nullptr);

// By choose_device(). Throws Error(no_device) where there are none.
const Candidate& choose(std::span<const Candidate> candidates, std::string_view wanted);

}  // namespace lamina::vulkan
