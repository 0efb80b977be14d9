// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/resources.h"

#include "harness/backend/opengl/gl_format.h"

namespace lamina::gl {
namespace {

uint32_t max_texels_3d() {
  GLint most = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
  return static_cast<uint32_t>(most);
}

}  // namespace

Texture make_texture(const TextureDesc& desc, std::span<const std::vector<std::byte>> levels, uint32_t max_size) {
  check_texture(desc, levels, max_size, max_texels_3d());
  const GlFormat format = gl_format(desc.format);
  GLuint name = 0;
  glCreateTextures(is_3d(desc) ? GL_TEXTURE_3D : GL_TEXTURE_2D, 1, &name);
  Texture texture{TextureObject(name), desc};
  label(GL_TEXTURE, name, desc.name);
  const auto width = static_cast<GLsizei>(desc.width), height = static_cast<GLsizei>(desc.height),
             depth = static_cast<GLsizei>(desc.depth), level_count = static_cast<GLsizei>(desc.levels);
  if (is_3d(desc))
    glTextureStorage3D(name, level_count, format.internal, width, height, depth);
  else
    glTextureStorage2D(name, level_count, format.internal, width, height);
  throw_on_error(desc.name);  // before the upload: there may be no room
  if (is_3d(desc) && !levels.empty())
    glTextureSubImage3D(name, 0, 0, 0, 0, width, height, depth, format.layout, format.type, levels[0].data());
  for (uint32_t level = 0; level < levels.size() && !is_3d(desc); ++level) {
    const Extent extent = level_extent(desc, level);
    glTextureSubImage2D(name, static_cast<GLint>(level), 0, 0, static_cast<GLsizei>(extent.width),
                        static_cast<GLsizei>(extent.height), format.layout, format.type, levels[level].data());
  }
  throw_on_error(desc.name);
  return texture;
}

// A view, as GL_TEXTURE_BASE_LEVEL belongs to the texture: one draw may read two levels of it.
GLuint level_view(Texture& texture, uint32_t level) {
  const TextureDesc& desc = texture.desc;
  check_level(desc, level);
  if (desc.levels == 1) return texture.object.name();
  texture.levels.resize(desc.levels);
  TextureObject& view = texture.levels[level];
  if (view.name() == 0) {
    GLuint name = 0;
    glGenTextures(1, &name);  // a view needs a name that is no texture yet
    view = TextureObject(name);
    glTextureView(name, GL_TEXTURE_2D, texture.object.name(), gl_format(desc.format).internal, level, 1, 0, 1);
    label(GL_TEXTURE, name, fmt::format("{} level {}", desc.name, level));
    throw_on_error(desc.name);
  }
  return view.name();
}

Buffer make_buffer(std::string name, size_t size_bytes, std::span<const std::byte> data) {
  if (size_bytes == 0) throw_bad_input(name, "a buffer of 0 bytes");
  GLuint object = 0;
  glCreateBuffers(1, &object);
  Buffer buffer{BufferObject(object), std::move(name), size_bytes};
  label(GL_BUFFER, object, buffer.name);
  glNamedBufferStorage(object, static_cast<GLsizeiptr>(size_bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
  throw_on_error(buffer.name);
  if (!data.empty()) write(buffer, data);
  return buffer;
}

void write(const Buffer& buffer, std::span<const std::byte> data) {
  if (data.size() > buffer.size_bytes)
    throw_bad_input(buffer.name, fmt::format("{} bytes written to a buffer of {}", data.size(), buffer.size_bytes));
  glNamedBufferSubData(buffer.object.name(), 0, static_cast<GLsizeiptr>(data.size()), data.data());
  throw_on_error(buffer.name);
}

std::vector<std::byte> read(const Texture& texture, uint32_t level) {
  const TextureDesc& desc = texture.desc;
  check_level(desc, level);
  constexpr size_t max_bytes = 0x7fffffff;  // glGetTextureImage counts bytes in a signed 32-bit integer
  if (level_bytes(desc, level) > max_bytes)
    throw_failed(desc.name, fmt::format("level {} has {} bytes, over the {} that OpenGL reads back at once", level,
                                        level_bytes(desc, level), max_bytes));
  const GlFormat format = gl_format(desc.format);
  std::vector<std::byte> texels(level_bytes(desc, level));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  glGetTextureImage(texture.object.name(), static_cast<GLint>(level), format.layout, format.type,
                    static_cast<GLsizei>(texels.size()), texels.data());
  throw_on_error(desc.name);
  return texels;
}

std::vector<std::byte> read(const Buffer& buffer) {
  std::vector<std::byte> bytes(buffer.size_bytes);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  glGetNamedBufferSubData(buffer.object.name(), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
  throw_on_error(buffer.name);
  return bytes;
}

Samplers::Samplers() {
  const auto edge = [](Wrap wrap) {
    return wrap == Wrap::mirror ? GL_MIRRORED_REPEAT : wrap == Wrap::clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
  };
  for (const Sampler sampler : all_samplers()) {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    label(GL_SAMPLER, name, name_of(sampler));
    const GLint within = sampler.filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, sampler.filter == Filter::trilinear ? GL_LINEAR_MIPMAP_LINEAR : within);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, within);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, edge(sampler.wrap));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, edge(sampler.wrap_v));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_R, edge(sampler.wrap));
    samplers_[place_of(sampler)] = SamplerObject(name);
  }
  throw_on_error("samplers");
}

}  // namespace lamina::gl
