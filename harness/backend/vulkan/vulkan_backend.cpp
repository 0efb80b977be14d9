// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/vulkan_backend.h"
namespace lamina {
std::unique_ptr<Backend> open_vulkan(const BackendOptions&) { throw Error(ErrorKind::no_device, "vulkan", "", "to do"); }
std::vector<DeviceInfo> list_vulkan_devices() { return {}; }
}  // namespace lamina
