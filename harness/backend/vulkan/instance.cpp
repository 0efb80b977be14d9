// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/instance.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "harness/backend/common/choose_device.h"
#include "harness/backend/vulkan/result.h"

namespace lamina::vulkan {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

[[noreturn]] void throw_no_device(std::string subject, std::string message) {
  throw Error(ErrorKind::no_device, "vulkan", std::move(subject), std::move(message));
}

bool has_layer(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(),
                     [&](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool has_debug_utils() {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(), [](const VkExtensionProperties& extension) {
    return std::strcmp(extension.extensionName, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) == 0;
  });
}

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
  static_cast<MessageList*>(messages)->add(data->pMessage);
  return VK_FALSE;
}

// The loader's own talk (type GENERAL) is left out: it warns of every installed driver that finds no hardware.
VkDebugUtilsMessengerCreateInfoEXT messenger_info(MessageList& messages) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = collect;
  info.pUserData = &messages;
  return info;
}

// Reads what shaders may use, and says what Lamina needs and the device lacks; "" where it has all.
std::string read_features(Candidate& candidate) {
  if (candidate.properties.apiVersion < VK_API_VERSION_1_3) return "has no Vulkan 1.3";
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &features13};
  VkPhysicalDeviceFeatures2 all{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features12, {}};
  vkGetPhysicalDeviceFeatures2(candidate.handle, &all);
  DeviceInfo& info = candidate.info;
  info.vertex_storage = all.features.vertexPipelineStoresAndAtomics;
  info.fragment_storage = all.features.fragmentStoresAndAtomics;
  info.half_floats = features12.shaderFloat16;
  info.doubles = all.features.shaderFloat64;
  info.exact_sample_counts = all.features.occlusionQueryPrecise;
  info.issued_fragment_counts = all.features.pipelineStatisticsQuery;
  if (!features13.dynamicRendering || !features13.synchronization2) return "has no dynamic rendering or no synchronization2";
  if (!info.vertex_storage) return "has no storage in vertex shaders";
  return info.fragment_storage ? "" : "has no storage in fragment shaders";
}

// Fills the queue family; false where no family both draws and computes.
bool find_queue_family(Candidate& candidate) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(candidate.handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(candidate.handle, &count, families.data());
  constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & needed) != needed) continue;
    candidate.queue_family = i;
    candidate.info.timestamp_bits = families[i].timestampValidBits;
    return true;
  }
  return false;
}

std::string version_text(uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version), VK_API_VERSION_PATCH(version));
}

void describe_device(Candidate& candidate) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceMaintenance3Properties sizes{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES, &driver};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &sizes, {}};
  vkGetPhysicalDeviceProperties2(candidate.handle, &properties);
  candidate.properties = properties.properties;
  candidate.max_allocation_bytes = sizes.maxMemoryAllocationSize;

  const VkPhysicalDeviceLimits& limits = candidate.properties.limits;
  DeviceInfo& info = candidate.info;
  info.backend = "vulkan";
  info.api = Api::vulkan;
  info.device = candidate.properties.deviceName;
  info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  info.api_version = version_text(candidate.properties.apiVersion);
  info.software = candidate.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.max_texture_size = std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight});
}

// The loader unloads drivers and layers with the last instance that uses them, and they leave their threads' data behind. So
// one idle instance of each kind stays until the process ends, which also makes the next one quick to open.
void keep_loaded(const VkInstanceCreateInfo& info, bool validation) {
  static std::array<VkInstance, 2> kept{};
  VkInstance& instance = kept[validation ? 1 : 0];
  if (instance == VK_NULL_HANDLE && vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS) instance = VK_NULL_HANDLE;
}

}  // namespace

void MessageList::add(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
}

std::vector<std::string> MessageList::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(messages_, {});
}

Instance::Instance(bool validation) {
  uint32_t version = VK_API_VERSION_1_0;
  vkEnumerateInstanceVersion(&version);
  if (version < VK_API_VERSION_1_3)
    throw_no_device("loader", fmt::format("Vulkan 1.3 is needed, the loader offers {}", version_text(version)));
  if (validation && !has_layer(validation_layer))
    throw_no_device(validation_layer, "the layer is not installed; install the package vulkan-validationlayers");
  debug_utils_ = has_debug_utils() || validation;

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "lamina";
  application.apiVersion = VK_API_VERSION_1_3;

  const VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(messages_);
  VkValidationFeaturesEXT checks{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, &messenger};
  constexpr VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  checks.enabledValidationFeatureCount = 1;
  checks.pEnabledValidationFeatures = &synchronization;

  const char* debug_extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  info.enabledExtensionCount = debug_utils_ ? 1 : 0;
  info.ppEnabledExtensionNames = &debug_extension;
  info.enabledLayerCount = validation ? 1 : 0;
  info.ppEnabledLayerNames = &validation_layer;
  keep_loaded(info, validation);
  if (validation) info.pNext = &checks;
  const VkResult created = vkCreateInstance(&info, nullptr, &instance_);
  if (created != VK_SUCCESS)
    throw_no_device("vkCreateInstance", describe(created) + "; the package mesa-vulkan-drivers brings a software rasterizer");

  if (!validation) return;
  const auto create =
      reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  const VkResult listening = create ? create(instance_, &messenger, nullptr, &messenger_) : VK_ERROR_EXTENSION_NOT_PRESENT;
  if (listening != VK_SUCCESS) {
    vkDestroyInstance(instance_, nullptr);
    throw_no_device("vkCreateDebugUtilsMessengerEXT", describe(listening));
  }
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  vkDestroyInstance(instance_, nullptr);
}

std::vector<Candidate> find_candidates(const Instance& instance, std::vector<RefusedDevice>* refused) {
  uint32_t count = 0;
  if (vkEnumeratePhysicalDevices(instance.get(), &count, nullptr) != VK_SUCCESS) return {};
  std::vector<VkPhysicalDevice> devices(count);
  if (vkEnumeratePhysicalDevices(instance.get(), &count, devices.data()) != VK_SUCCESS) return {};
  std::vector<Candidate> candidates;
  for (VkPhysicalDevice device : devices) {
    Candidate candidate;
    candidate.handle = device;
    vkGetPhysicalDeviceProperties(device, &candidate.properties);
    std::string lacks = read_features(candidate);
    if (lacks.empty() && !find_queue_family(candidate)) lacks = "has no queue that both draws and computes";
    if (lacks.empty()) {
      describe_device(candidate);
      candidates.push_back(std::move(candidate));
    } else if (refused) {
      refused->push_back({candidate.properties.deviceName, lacks});
    }
  }
  return candidates;
}

const Candidate& choose(std::span<const Candidate> candidates, std::string_view wanted) {
  if (candidates.empty())
    throw_no_device(std::string(wanted),
                    "no device with Vulkan 1.3, dynamic rendering and storage writes from all stages; the package "
                    "mesa-vulkan-drivers brings a software one");
  std::vector<DeviceInfo> devices;
  for (const Candidate& candidate : candidates) devices.push_back(candidate.info);
  return candidates[choose_device("vulkan", devices, wanted)];
}

}  // namespace lamina::vulkan
