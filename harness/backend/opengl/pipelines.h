// SPDX-License-Identifier: Apache-2.0
// A linked program with the state that it draws with.
#pragma once

#include <vector>

#include "harness/backend/backend.h"
#include "harness/backend/opengl/object.h"

namespace lamina::gl {

struct Pipeline {
  struct Slot {
    BindingSlot slot;
    GLuint unit = 0;  // texture unit, image unit, or buffer binding point
  };

  ProgramObject program;
  VertexArrayObject vertex_array;
  std::vector<Slot> slots;
  PipelineDesc desc;  // without the shaders' words
};

// As Backend::create_pipeline says.
Pipeline make_pipeline(const PipelineDesc& desc);

// State that no pipeline changes: the conventions of backend.h. Once for each context.
void set_conventions();

// Makes the pipeline current: program, vertex array, blending, depth and culling.
void use(const Pipeline& pipeline);

}  // namespace lamina::gl
