// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/object.h"

namespace lamina::gl {
namespace {

std::string error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return fmt::format("GL error 0x{:04x}", error);
  }
}

}  // namespace

void throw_on_error(std::string_view subject) {
  std::string errors;
  constexpr int most = 16;  // a lost context may report without end
  for (int i = 0; i < most; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    errors += (errors.empty() ? "" : ", ") + error_name(error);
  }
  if (errors.empty()) return;
  throw_failed(subject, fmt::format("the driver reports {}; its own words come with validation switched on", errors));
}

}  // namespace lamina::gl
