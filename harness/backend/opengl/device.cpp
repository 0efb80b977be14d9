// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/device.h"

#include <algorithm>
#include <array>

namespace lamina::gl {
namespace {

std::string text_of(GLenum what) {
  const GLubyte* text = glGetString(what);
  return text ? reinterpret_cast<const char*>(text) : "";
}

// GL_VERSION is the version, a space, and whatever the vendor adds; Mesa puts the profile first:
// "4.5 (Core Profile) Mesa 22.3.6", "4.5.0 NVIDIA 550.54".
std::string driver_of(const std::string& version, const std::string& vendor) {
  constexpr std::string_view profile = "(Core Profile) ";
  const size_t space = version.find(' ');
  if (space == std::string::npos) return vendor;
  std::string driver = version.substr(space + 1);
  if (driver.starts_with(profile)) driver.erase(0, profile.size());
  return driver;
}

uint32_t largest_target() {
  GLint texture = 0, width = 0, height = 0;
  std::array<GLint, 2> viewport = {};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_FRAMEBUFFER_WIDTH, &width);
  glGetIntegerv(GL_MAX_FRAMEBUFFER_HEIGHT, &height);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  return static_cast<uint32_t>(std::min({texture, width, height, viewport[0], viewport[1]}));
}

bool has_extension(std::string_view name) {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    if (const GLubyte* one = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        one && name == reinterpret_cast<const char*>(one))
      return true;
  return false;
}

uint32_t integer_of(GLenum what) {
  GLint value = 0;
  glGetIntegerv(what, &value);
  return static_cast<uint32_t>(std::max(value, 0));
}

void describe_abilities(DeviceInfo& info) {
  info.vertex_storage = integer_of(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS) > 0 && integer_of(GL_MAX_VERTEX_IMAGE_UNIFORMS) > 0;
  info.fragment_storage =
      integer_of(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS) > 0 && integer_of(GL_MAX_FRAGMENT_IMAGE_UNIFORMS) > 0;
  info.half_floats = has_extension("GL_AMD_gpu_shader_half_float") || has_extension("GL_NV_gpu_shader5");
  info.doubles = true;              // since OpenGL 4.0
  info.exact_sample_counts = true;  // GL_SAMPLES_PASSED
  info.issued_fragment_counts = has_extension("GL_ARB_pipeline_statistics_query");
  GLint bits = 0;
  glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
  info.timestamp_bits = static_cast<uint32_t>(std::max(bits, 0));
}

}  // namespace

DeviceInfo load_and_describe(const Context& context, std::string_view backend) {
  const int version = gladLoadGL(context.loader());
  if (version == 0) throw Error(ErrorKind::no_device, std::string(backend), "context", "its entry points cannot be loaded");

  DeviceInfo info;
  info.backend = backend;
  info.api = Api::opengl;
  info.device = text_of(GL_RENDERER);
  info.driver = driver_of(text_of(GL_VERSION), text_of(GL_VENDOR));
  info.api_version = fmt::format("{}.{}", GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version));
  // Mesa's rasterizers on the CPU, by the names they give themselves.
  for (std::string_view name : {"llvmpipe", "softpipe", "SWR", "swrast", "Software Rasterizer"})
    info.software = info.software || info.device.find(name) != std::string::npos;

  if (!GLAD_GL_VERSION_4_5)
    throw Error(ErrorKind::no_device, info.backend, info.device,
                fmt::format("OpenGL 4.5 is needed, the driver has {}", info.api_version));
  if (!GLAD_GL_ARB_gl_spirv) throw Error(ErrorKind::no_device, info.backend, info.device, "the driver lacks GL_ARB_gl_spirv");
  info.max_texture_size = largest_target();
  describe_abilities(info);
  return info;
}

}  // namespace lamina::gl
