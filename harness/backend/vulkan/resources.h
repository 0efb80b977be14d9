// SPDX-License-Identifier: Apache-2.0
// Textures and buffers: made, filled, read back. One memory allocation each, but for textures that are needed at different
// times, which may lie in one. Buffers that only the host writes (uniforms) are
// mapped; everything else lives in the device's own memory and is reached through one staging buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harness/backend/common/checks.h"
#include "harness/backend/common/table.h"
#include "harness/backend/vulkan/device.h"

namespace lamina::vulkan {

// One allocation for textures that are needed at different times.
struct SharedMemory {
  struct Place {
    VkDeviceSize begin = 0, end = 0;
    std::vector<bool> filled;  // [level], after all that was submitted: whether it holds what was put there
  };
  MemoryHandle memory;
  std::vector<Place> places;  // one a texture
};

struct Texture {
  TextureDesc desc;
  MemoryHandle memory;                   // its own; before the image: freed after it
  std::shared_ptr<SharedMemory> shared;  // where it has none of its own
  size_t place = 0;                      // in that
  ImageHandle image;
  ImageViewHandle whole;                // every level, for sampling
  std::vector<ImageViewHandle> levels;  // one level each
  std::vector<VkImageLayout> layouts;   // of each level, after all that was submitted
};

struct Buffer {
  std::string name;
  BufferUse use = BufferUse::storage;
  size_t size_bytes = 0;
  MemoryHandle memory;
  BufferHandle buffer;
  std::byte* mapped = nullptr;  // where the host reaches it directly
};

// The barrier that brings one level from its layout to `layout`, and notes it there.
VkImageMemoryBarrier2 transition(Texture& texture, uint32_t level, VkImageLayout layout);
// The same for a while: the texture's own note of its layout stays.
VkImageMemoryBarrier2 transition(const Texture& texture, uint32_t level, VkImageLayout from, VkImageLayout to);

class Resources {
 public:
  explicit Resources(Device& device) : device_(device) {}

  // As Backend's functions of these names.
  TextureId create_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels);
  PlacedTextures create_textures(std::span<const TransientDesc> descs);
  BufferId create_buffer(std::string name, BufferUse use, size_t size_bytes, std::span<const std::byte> data);
  void destroy(TextureId id) { textures_.erase(id); }
  void destroy(BufferId id) { buffers_.erase(id); }
  void write_buffer(BufferId id, std::span<const std::byte> data);
  std::vector<std::byte> read_texture(TextureId id, uint32_t level);
  std::vector<std::byte> read_buffer(BufferId id);

  Texture& at(TextureId id, std::string_view subject) { return textures_.at(id, subject); }
  Buffer& at(BufferId id, std::string_view subject) { return buffers_.at(id, subject); }

 private:
  // `more`: allocations that are about to be made beside this one.
  void check_new(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, size_t more) const;
  void check_room(const std::string& subject, size_t more) const;
  void write(Buffer& buffer, std::span<const std::byte> data);
  Buffer make_buffer(const std::string& name, size_t size_bytes, VkBufferUsageFlags usage, MemoryUse memory);
  // A texture is made in three steps: an image, what it asks of memory, and views once it has memory.
  Texture make_image(const TextureDesc& desc);
  VkMemoryRequirements needed_by(const Texture& texture) const;
  void give_memory(Texture& texture, const VkMemoryRequirements& needed);
  void make_views(Texture& texture);
  // Returns the bytes of the memory, or 0 where the device gives no such memory at once: the textures then have none.
  VkDeviceSize share_memory(std::span<const TransientDesc> descs, std::span<const VkMemoryRequirements> needed,
                            std::span<const size_t> which, std::vector<Texture>& textures);
  void upload(Texture& texture, std::span<const std::vector<std::byte>> levels);
  // The staging buffer, at least this large; give_back_staging() frees it where it grew too large to keep.
  Buffer& staging(size_t size_bytes);
  void give_back_staging();

  Device& device_;
  Buffer staging_;
  Table<TextureId, Texture> textures_{"texture"};
  Table<BufferId, Buffer> buffers_{"buffer"};
};

}  // namespace lamina::vulkan
