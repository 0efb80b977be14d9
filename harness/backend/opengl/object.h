// SPDX-License-Identifier: Apache-2.0
// Ownership, naming and error checks for OpenGL objects. All of it needs a current context with glad loaded.
#pragma once

#include <glad/gl.h>

#include <string>
#include <string_view>
#include <utility>

#include "harness/core/error.h"

namespace lamina::gl {

// `subject` is the name of the texture, buffer, pipeline or pass.
[[noreturn]] inline void throw_failed(std::string_view subject, std::string message) {
  throw Error(ErrorKind::failed, "opengl", std::string(subject), std::move(message));
}
[[noreturn]] inline void throw_bad_input(std::string_view subject, std::string message) {
  throw Error(ErrorKind::bad_input, "opengl", std::string(subject), std::move(message));
}

// Owns one OpenGL name; 0 owns nothing.
template <void (*destroy)(GLuint)>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint name) : name_(name) {}
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object() {
    if (name_ != 0) destroy(name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void destroy_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void destroy_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void destroy_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void destroy_sampler(GLuint name) { glDeleteSamplers(1, &name); }
inline void destroy_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void destroy_query(GLuint name) { glDeleteQueries(1, &name); }
inline void destroy_shader(GLuint name) { glDeleteShader(name); }
inline void destroy_program(GLuint name) { glDeleteProgram(name); }

using TextureObject = Object<destroy_texture>;
using BufferObject = Object<destroy_buffer>;
using FramebufferObject = Object<destroy_framebuffer>;
using SamplerObject = Object<destroy_sampler>;
using VertexArrayObject = Object<destroy_vertex_array>;
using QueryObject = Object<destroy_query>;
using ShaderObject = Object<destroy_shader>;
using ProgramObject = Object<destroy_program>;

// Names an object for debuggers and for the driver's messages.
inline void label(GLenum kind, GLuint name, std::string_view text) {
  constexpr size_t longest = 255;  // MAX_LABEL_LENGTH is at least 256, terminator included (OpenGL 4.5, table 23.62)
  text = text.substr(0, longest);
  glObjectLabel(kind, name, static_cast<GLsizei>(text.size()), text.data());
}

// Throws Error(failed) about `subject` with the names of all errors that OpenGL has noted since the last call.
void throw_on_error(std::string_view subject);

}  // namespace lamina::gl
