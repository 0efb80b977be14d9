// SPDX-License-Identifier: Apache-2.0
// Lamina's formats, as Vulkan names them.
#pragma once

#include <vulkan/vulkan.h>

#include "harness/core/format.h"

namespace lamina::vulkan {

VkFormat vk_format(Format format);
inline VkImageAspectFlags aspect_of(Format format) {
  return is_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

}  // namespace lamina::vulkan
