// SPDX-License-Identifier: Apache-2.0
#include "harness/backend/opengl/debug_log.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <string_view>
#include <utility>

namespace lamina::gl {
namespace {

std::string_view type_name(GLenum type) {
  switch (type) {
    case GL_DEBUG_TYPE_ERROR:
      return "error";
    case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
      return "deprecated";
    case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
      return "undefined behaviour";
    case GL_DEBUG_TYPE_PORTABILITY:
      return "portability";
    default:
      return "warning";
  }
}

void GLAD_API_PTR collect(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
                          const void* user) {
  const bool serious = severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
  if (!serious || type == GL_DEBUG_TYPE_PERFORMANCE) return;
  auto& messages = *static_cast<std::vector<std::string>*>(const_cast<void*>(user));
  std::string_view words = length < 0 ? std::string_view(text) : std::string_view(text, static_cast<size_t>(length));
  while (words.ends_with('\n') || words.ends_with('\0')) words.remove_suffix(1);
  messages.push_back(fmt::format("{} {}: {}", type_name(type), id, words));
}

}  // namespace

void DebugLog::listen() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect, &messages_);
}

std::vector<std::string> DebugLog::take() { return std::exchange(messages_, {}); }

}  // namespace lamina::gl
