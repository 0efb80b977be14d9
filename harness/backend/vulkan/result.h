// SPDX-License-Identifier: Apache-2.0
// Vulkan's result codes as Lamina's errors.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <string_view>

#include "harness/core/error.h"

namespace lamina::vulkan {

// "VK_ERROR_DEVICE_LOST (the device was lost: ...)".
std::string describe(VkResult result);

// Throws Error(failed, "vulkan", subject, "CALL: result") unless `result` is VK_SUCCESS.
inline void check(VkResult result, std::string_view subject, std::string_view call) {
  if (result == VK_SUCCESS) return;
  throw Error(ErrorKind::failed, "vulkan", std::string(subject), fmt::format("{}: {}", call, describe(result)));
}

[[noreturn]] inline void throw_bad_input(std::string_view subject, std::string message) {
  throw Error(ErrorKind::bad_input, "vulkan", std::string(subject), std::move(message));
}

[[noreturn]] inline void throw_failed(std::string_view subject, std::string message) {
  throw Error(ErrorKind::failed, "vulkan", std::string(subject), std::move(message));
}

}  // namespace lamina::vulkan
