// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/vulkan/resources.h"

#include <algorithm>
#include <cstring>
#include <map>

#include "harness/backend/common/shared_memory.h"
#include "harness/backend/vulkan/formats.h"

namespace lamina::vulkan {
namespace {

// Staging that is kept between transfers; larger ones are freed after use. Enough for a 2048x2048 rgba16_float target.
constexpr size_t staging_kept_bytes = size_t{32} << 20;
constexpr size_t staging_least_bytes = size_t{1} << 16;

// Texels of the levels in one buffer must start at multiples of their size, and of 4 for depth (Vulkan 1.3, VkBufferImageCopy).
constexpr size_t copy_alignment_bytes = 16;

size_t aligned(size_t bytes) { return (bytes + copy_alignment_bytes - 1) / copy_alignment_bytes * copy_alignment_bytes; }

VkBufferImageCopy copy_of(const TextureDesc& desc, uint32_t level, size_t offset) {
  const Extent extent = level_extent(desc, level);
  VkBufferImageCopy copy{};
  copy.bufferOffset = offset;
  copy.imageSubresource = {aspect_of(desc.format), level, 0, 1};
  copy.imageExtent = {extent.width, extent.height, desc.depth};
  return copy;
}

VkBufferUsageFlags usage_of(BufferUse use) {
  constexpr VkBufferUsageFlags copied = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  switch (use) {
    case BufferUse::vertex:
      return copied | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
    case BufferUse::index:
      return copied | VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
    case BufferUse::uniform:
      return copied | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    case BufferUse::storage:
      return copied | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  }
  return copied;
}

VkFormatFeatureFlags features_of(const TextureDesc& desc) {
  VkFormatFeatureFlags features =
      VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
  if (desc.target)
    features |= is_depth(desc.format) ? VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
  if (desc.storage) features |= VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
  return features;
}

VkImageUsageFlags usage_of(const TextureDesc& desc) {
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (desc.target)
    usage |= is_depth(desc.format) ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (desc.storage) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  return usage;
}

VkImageType image_type(const TextureDesc& desc) { return is_3d(desc) ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D; }

void check_on_device(const Device& device, const TextureDesc& desc) {
  if (!device.supports(vk_format(desc.format), features_of(desc)))
    throw_failed(desc.name, fmt::format("{} cannot use {} as {}", device.info().device, name_of(desc.format),
                                        desc.storage  ? "a storage image"
                                        : desc.target ? "a target"
                                                      : "a texture"));
  VkImageFormatProperties format_limits{};
  check(vkGetPhysicalDeviceImageFormatProperties(device.physical(), vk_format(desc.format), image_type(desc),
                                                 VK_IMAGE_TILING_OPTIMAL, usage_of(desc), 0, &format_limits),
        desc.name, "vkGetPhysicalDeviceImageFormatProperties");
  const uint64_t size_bytes = texture_bytes(desc);
  if (size_bytes > format_limits.maxResourceSize)
    throw_failed(desc.name, fmt::format("it takes {} bytes and {} makes textures of at most {}; use a smaller size", size_bytes,
                                        device.info().device, format_limits.maxResourceSize));
}

}  // namespace

VkImageMemoryBarrier2 transition(const Texture& texture, uint32_t level, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = texture.image.get();
  barrier.subresourceRange = {aspect_of(texture.desc.format), level, 1, 0, 1};
  return barrier;
}

VkImageMemoryBarrier2 transition(Texture& texture, uint32_t level, VkImageLayout layout) {
  return transition(texture, level, std::exchange(texture.layouts[level], layout), layout);
}

void Resources::check_new(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, size_t more) const {
  check_texture(desc, levels, device_.info().max_texture_size, device_.limits().maxImageDimension3D);
  check_on_device(device_, desc);
  check_room(desc.name, more);
}

TextureId Resources::create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels) {
  check_new(desc, levels, 0);
  Texture texture = make_image(desc);
  give_memory(texture, needed_by(texture));
  make_views(texture);
  if (!levels.empty()) upload(texture, levels);
  return textures_.add(std::move(texture));
}

PlacedTextures Resources::create_textures(std::span<const TransientDesc> descs) {
  std::vector<Texture> textures;
  std::vector<VkMemoryRequirements> needed;
  std::map<uint32_t, std::vector<size_t>> transient;  // by the types of memory that they may lie in
  PlacedTextures placed;
  for (size_t i = 0; i < descs.size(); ++i) {
    check_new(descs[i].texture, {}, i);
    textures.push_back(make_image(descs[i].texture));
    needed.push_back(needed_by(textures.back()));
    placed.bytes_alone += needed.back().size;
    if (descs[i].lifetime) transient[needed.back().memoryTypeBits].push_back(i);
  }
  for (const auto& [types, which] : transient)
    if (which.size() > 1) placed.bytes += share_memory(descs, needed, which, textures);
  for (size_t i = 0; i < textures.size(); ++i) {
    if (!textures[i].shared) {
      give_memory(textures[i], needed[i]);
      placed.bytes += needed[i].size;
    }
    make_views(textures[i]);
  }
  for (Texture& texture : textures) placed.textures.push_back(textures_.add(std::move(texture)));
  return placed;
}

// Nothing but images with optimal tiling lies in the memory, so bufferImageGranularity, which parts linear from other
// resources, asks for nothing.
VkDeviceSize Resources::share_memory(std::span<const TransientDesc> descs, std::span<const VkMemoryRequirements> needed,
                                     std::span<const size_t> which, std::vector<Texture>& textures) {
  std::vector<MemoryNeed> needs;
  VkMemoryRequirements all{0, 1, needed[which.front()].memoryTypeBits};
  for (const size_t i : which) {
    needs.push_back({needed[i].size, needed[i].alignment, *descs[i].lifetime});
    all.alignment = std::max(all.alignment, needed[i].alignment);
  }
  const MemoryPlaces places = place_in_memory(needs);
  all.size = places.bytes;
  if (all.size > device_.most_at_once(all, MemoryUse::device)) return 0;
  const auto shared = std::make_shared<SharedMemory>();
  shared->memory = device_.allocate(all, MemoryUse::device, "targets in turn");
  for (size_t k = 0; k < which.size(); ++k) {
    Texture& texture = textures[which[k]];
    check(vkBindImageMemory(device_.get(), texture.image.get(), shared->memory.get(), places.offsets[k]), texture.desc.name,
          "vkBindImageMemory");
    texture.shared = shared;
    texture.place = k;
    shared->places.push_back(
        {places.offsets[k], places.offsets[k] + needs[k].bytes, std::vector<bool>(texture.desc.levels, false)});
  }
  return all.size;
}

BufferId Resources::create_buffer(std::string name, BufferUse use, size_t size_bytes, std::span<const std::byte> data) {
  if (size_bytes == 0) throw_bad_input(name, "a buffer of 0 bytes");
  const VkPhysicalDeviceLimits& limits = device_.limits();
  const size_t most = use == BufferUse::uniform   ? limits.maxUniformBufferRange
                      : use == BufferUse::storage ? limits.maxStorageBufferRange
                                                  : size_bytes;
  if (size_bytes > most)
    throw_failed(name, fmt::format("{} bytes; {} binds at most {}", size_bytes, device_.info().device, most));
  check_room(name, 0);
  Buffer buffer = make_buffer(name, size_bytes, usage_of(use), use == BufferUse::uniform ? MemoryUse::host : MemoryUse::device);
  buffer.use = use;
  write(buffer, data);
  return buffers_.add(std::move(buffer));
}

void Resources::write_buffer(BufferId id, std::span<const std::byte> data) { write(at(id, "write_buffer"), data); }

void Resources::write(Buffer& buffer, std::span<const std::byte> data) {
  if (data.size() > buffer.size_bytes)
    throw_bad_input(buffer.name, fmt::format("{} bytes written to a buffer of {}", data.size(), buffer.size_bytes));
  if (data.empty()) return;
  if (buffer.mapped != nullptr) {
    std::memcpy(buffer.mapped, data.data(), data.size());
    return;
  }
  Buffer& stage = staging(data.size());
  std::memcpy(stage.mapped, data.data(), data.size());
  const VkCommandBuffer commands = device_.begin();
  full_barrier(commands);
  const VkBufferCopy copy{0, 0, data.size()};
  vkCmdCopyBuffer(commands, stage.buffer.get(), buffer.buffer.get(), 1, &copy);
  full_barrier(commands);
  device_.submit_and_wait(commands);
  give_back_staging();
}

std::vector<std::byte> Resources::read_buffer(BufferId id) {
  Buffer& buffer = at(id, "read_buffer");
  if (buffer.mapped != nullptr) return {buffer.mapped, buffer.mapped + buffer.size_bytes};
  Buffer& stage = staging(buffer.size_bytes);
  const VkCommandBuffer commands = device_.begin();
  full_barrier(commands);
  const VkBufferCopy copy{0, 0, buffer.size_bytes};
  vkCmdCopyBuffer(commands, buffer.buffer.get(), stage.buffer.get(), 1, &copy);
  full_barrier(commands);
  device_.submit_and_wait(commands);
  std::vector<std::byte> bytes(stage.mapped, stage.mapped + buffer.size_bytes);
  give_back_staging();
  return bytes;
}

std::vector<std::byte> Resources::read_texture(TextureId id, uint32_t level) {
  Texture& texture = at(id, "read_texture");
  check_level(texture.desc, level);
  if (texture.shared && !texture.shared->places[texture.place].filled[level])
    throw_bad_input(texture.desc.name,
                    fmt::format("level {} is read back and holds nothing: another texture has had its memory since", level));
  const size_t size_bytes = level_bytes(texture.desc, level);
  Buffer& stage = staging(size_bytes);
  const VkCommandBuffer commands = device_.begin();
  const VkImageMemoryBarrier2 to_source = transition(texture, level, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  full_barrier(commands, {&to_source, 1});
  const VkBufferImageCopy copy = copy_of(texture.desc, level, 0);
  vkCmdCopyImageToBuffer(commands, texture.image.get(), texture.layouts[level], stage.buffer.get(), 1, &copy);
  full_barrier(commands);
  device_.submit_and_wait(commands);
  std::vector<std::byte> bytes(stage.mapped, stage.mapped + size_bytes);
  give_back_staging();
  return bytes;
}

void Resources::check_room(const std::string& subject, size_t more) const {
  // One allocation each, and one for staging.
  const size_t most = device_.limits().maxMemoryAllocationCount, exist = textures_.size() + buffers_.size() + more;
  if (exist + 2 > most)
    throw_failed(subject, fmt::format("{} textures and buffers exist, the device allows {}", exist, most - 1));
}

Buffer Resources::make_buffer(const std::string& name, size_t size_bytes, VkBufferUsageFlags usage, MemoryUse memory) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size_bytes;
  info.usage = usage;
  VkBuffer created = VK_NULL_HANDLE;
  check(vkCreateBuffer(device_.get(), &info, nullptr, &created), name, "vkCreateBuffer");
  Buffer buffer;
  buffer.name = name;
  buffer.size_bytes = size_bytes;
  buffer.buffer = device_.own<BufferHandle>(created, name);
  VkMemoryRequirements needed{};
  vkGetBufferMemoryRequirements(device_.get(), created, &needed);
  buffer.memory = device_.allocate(needed, memory, name);
  check(vkBindBufferMemory(device_.get(), created, buffer.memory.get(), 0), name, "vkBindBufferMemory");
  if (memory == MemoryUse::host) {
    void* mapped = nullptr;
    check(vkMapMemory(device_.get(), buffer.memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped), name, "vkMapMemory");
    buffer.mapped = static_cast<std::byte*>(mapped);
  }
  return buffer;
}

Texture Resources::make_image(const TextureDesc& desc) {
  Texture texture;
  texture.desc = desc;
  texture.layouts.assign(desc.levels, VK_IMAGE_LAYOUT_UNDEFINED);
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = image_type(desc);
  info.format = vk_format(desc.format);
  info.extent = {desc.width, desc.height, desc.depth};
  info.mipLevels = desc.levels;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = usage_of(desc);
  VkImage image = VK_NULL_HANDLE;
  check(vkCreateImage(device_.get(), &info, nullptr, &image), desc.name, "vkCreateImage");
  texture.image = device_.own<ImageHandle>(image, desc.name);
  return texture;
}

VkMemoryRequirements Resources::needed_by(const Texture& texture) const {
  VkMemoryRequirements needed{};
  vkGetImageMemoryRequirements(device_.get(), texture.image.get(), &needed);
  return needed;
}

void Resources::give_memory(Texture& texture, const VkMemoryRequirements& needed) {
  texture.memory = device_.allocate(needed, MemoryUse::device, texture.desc.name);
  check(vkBindImageMemory(device_.get(), texture.image.get(), texture.memory.get(), 0), texture.desc.name, "vkBindImageMemory");
}

void Resources::make_views(Texture& texture) {
  const TextureDesc& desc = texture.desc;
  const auto view_of = [&](uint32_t level, uint32_t count, const std::string& name) {
    VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view_info.image = texture.image.get();
    view_info.viewType = is_3d(desc) ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = vk_format(desc.format);
    view_info.subresourceRange = {aspect_of(desc.format), level, count, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device_.get(), &view_info, nullptr, &view), desc.name, "vkCreateImageView");
    return device_.own<ImageViewHandle>(view, name);
  };
  texture.whole = view_of(0, desc.levels, desc.name);
  for (uint32_t level = 0; level < desc.levels; ++level)
    texture.levels.push_back(view_of(level, 1, fmt::format("{} level {}", desc.name, level)));
}

void Resources::upload(Texture& texture, std::span<const std::vector<std::byte>> levels) {
  size_t size_bytes = 0;
  for (const std::vector<std::byte>& level : levels) size_bytes += aligned(level.size());
  Buffer& stage = staging(size_bytes);
  std::vector<VkBufferImageCopy> copies;
  std::vector<VkImageMemoryBarrier2> to_destination;
  size_t offset = 0;
  for (uint32_t level = 0; level < levels.size(); ++level) {
    std::memcpy(stage.mapped + offset, levels[level].data(), levels[level].size());
    copies.push_back(copy_of(texture.desc, level, offset));
    to_destination.push_back(transition(texture, level, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
    offset += aligned(levels[level].size());
  }
  const VkCommandBuffer commands = device_.begin();
  full_barrier(commands, to_destination);
  vkCmdCopyBufferToImage(commands, stage.buffer.get(), texture.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                         static_cast<uint32_t>(copies.size()), copies.data());
  full_barrier(commands);
  device_.submit_and_wait(commands);
  give_back_staging();
}

Buffer& Resources::staging(size_t size_bytes) {
  if (staging_.size_bytes < size_bytes) {
    constexpr VkBufferUsageFlags copied = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    staging_ = {};
    staging_ = make_buffer("lamina staging", std::max(size_bytes, staging_least_bytes), copied, MemoryUse::host);
  }
  return staging_;
}

void Resources::give_back_staging() {
  if (staging_.size_bytes > staging_kept_bytes) staging_ = {};
}

}  // namespace lamina::vulkan
