// SPDX-License-Identifier: Apache-2.0
// OpenGL's words for lamina::Format: how texels are stored, and how they lie in host memory (tightly packed, as in
// core/image.h).
#pragma once

#include <glad/gl.h>

#include <array>

#include "harness/core/format.h"

namespace lamina::gl {

struct GlFormat {
  GLenum internal, layout, type;
};

inline GlFormat gl_format(Format format) {
  static constexpr std::array<GlFormat, 12> formats = {{
      {GL_R8, GL_RED, GL_UNSIGNED_BYTE},
      {GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
      {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
      {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE},
      {GL_R16F, GL_RED, GL_HALF_FLOAT},
      {GL_RG16F, GL_RG, GL_HALF_FLOAT},
      {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
      {GL_R32F, GL_RED, GL_FLOAT},
      {GL_RG32F, GL_RG, GL_FLOAT},
      {GL_RGBA32F, GL_RGBA, GL_FLOAT},
      {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
      {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
  }};
  return formats.at(static_cast<size_t>(format));
}

}  // namespace lamina::gl
