// SPDX-License-Identifier: Apache-2.0
// A pass checked and put into OpenGL's names, before the clock of its frame starts: what runs is a plain list of calls.
#pragma once

#include <span>
#include <vector>

#include "harness/backend/backend.h"
#include "harness/backend/opengl/framebuffers.h"
#include "harness/backend/opengl/pipelines.h"
#include "harness/backend/opengl/resources.h"

namespace lamina::gl {

struct Resources {
  Table<TextureId, Texture> textures{"texture"};
  Table<BufferId, Buffer> buffers{"buffer"};
  Table<PipelineId, Pipeline> pipelines{"pipeline"};
  Samplers samplers;
  Framebuffers framebuffers;
};

// What lies at one unit of a draw.
struct BoundResource {
  BindingKind kind = BindingKind::texture;
  GLuint unit = 0;
  GLuint name = 0;     // of the texture or buffer
  GLuint sampler = 0;  // textures
  GLint level = 0;     // images
  GLenum format = GL_NONE;
};
struct PreparedDraw {
  const Pipeline* pipeline = nullptr;
  std::vector<BoundResource> bound;
  GLuint vertices = 0, indices = 0;  // buffers; 0: none
  const Draw* draw = nullptr;        // counts
};
struct PreparedAttachment {
  Load load = Load::clear;
  std::array<float, 4> clear = {};
  bool integer = false;
};
struct PreparedCopy {
  GLuint from = 0, to = 0;
  GLsizei width = 0, height = 0;  // pixels
};
struct PreparedPass {
  const Pass* pass = nullptr;
  GLuint framebuffer = 0;  // of a raster pass, and its size
  Extent size;
  std::vector<PreparedAttachment> colors;
  std::vector<PreparedDraw> draws;
  GLuint mips_of = 0;
  PreparedCopy copy;
};

// Throws Error(bad_input) about the pass, or the pipeline, where they do not fit together. The result points into `resources`
// and `passes`.
std::vector<PreparedPass> prepare(Resources& resources, std::span<const Pass> passes);

}  // namespace lamina::gl
