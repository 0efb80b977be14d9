// SPDX-License-Identifier: Apache-2.0
// Textures, buffers and samplers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "harness/backend/common/checks.h"
#include "harness/backend/opengl/object.h"

namespace lamina::gl {

struct Texture {
  TextureObject object;
  TextureDesc desc;
  std::vector<TextureObject> levels = {};  // views of one level each; 0 where none was asked for
};

struct Buffer {
  BufferObject object;
  std::string name;
  size_t size_bytes = 0;
};

// As Backend::create_texture and create_buffer say. `max_size` is in pixels.
Texture make_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, uint32_t max_size);
// The texture as one of its levels alone, made when it is first asked for. Throws Error(bad_input) where there is no such
// level.
GLuint level_view(Texture& texture, uint32_t level);
Buffer make_buffer(std::string name, size_t size_bytes, std::span<const std::byte> data);
void write(const Buffer& buffer, std::span<const std::byte> data);
std::vector<std::byte> read(const Texture& texture, uint32_t level);
std::vector<std::byte> read(const Buffer& buffer);

// The samplers that lamina::Sampler can name.
class Samplers {
 public:
  Samplers();
  GLuint of(Sampler sampler) const { return samplers_[place_of(sampler)].name(); }

 private:
  std::array<SamplerObject, sampler_count> samplers_;
};

}  // namespace lamina::gl
