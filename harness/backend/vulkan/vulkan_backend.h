// SPDX-License-Identifier: Apache-2.0
// The Vulkan 1.3 backend; see backend.h for what it promises.
#pragma once

#include "harness/backend/backend.h"

namespace lamina {

std::unique_ptr<Backend> open_vulkan(const BackendOptions& options);
std::vector<DeviceInfo> list_vulkan_devices();
std::vector<RefusedDevice> list_refused_vulkan_devices();  // the driver itself where it does not start

}  // namespace lamina
