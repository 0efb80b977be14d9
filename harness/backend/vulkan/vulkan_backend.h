// SPDX-License-Identifier: Apache-2.0
// The Vulkan 1.3 backend; see backend.h for what it promises.
#pragma once

#include "harness/backend/backend.h"

namespace lamina {

std::unique_ptr<Backend> open_vulkan(const BackendOptions& options);
DeviceSurvey survey_vulkan_devices();  // what is refused is the driver itself where it does not start

}  // namespace lamina
