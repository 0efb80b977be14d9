// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/formats.h"

namespace lamina::vulkan {

VkFormat vk_format(Format format) {
  switch (format) {
    case Format::r8_unorm:
      return VK_FORMAT_R8_UNORM;
    case Format::rg8_unorm:
      return VK_FORMAT_R8G8_UNORM;
    case Format::rgba8_unorm:
      return VK_FORMAT_R8G8B8A8_UNORM;
    case Format::rgba8_srgb:
      return VK_FORMAT_R8G8B8A8_SRGB;
    case Format::r16_float:
      return VK_FORMAT_R16_SFLOAT;
    case Format::rg16_float:
      return VK_FORMAT_R16G16_SFLOAT;
    case Format::rgba16_float:
      return VK_FORMAT_R16G16B16A16_SFLOAT;
    case Format::r32_float:
      return VK_FORMAT_R32_SFLOAT;
    case Format::rg32_float:
      return VK_FORMAT_R32G32_SFLOAT;
    case Format::rgba32_float:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    case Format::r32_uint:
      return VK_FORMAT_R32_UINT;
    case Format::d32_float:
      return VK_FORMAT_D32_SFLOAT;
  }
  return VK_FORMAT_UNDEFINED;
}

}  // namespace lamina::vulkan
