// SPDX-License-Identifier: Apache-2.0
// The passes of a frame as OpenGL calls.
#pragma once

#include <span>

#include "harness/backend/backend.h"
#include "harness/backend/opengl/framebuffers.h"
#include "harness/backend/opengl/pipelines.h"
#include "harness/backend/opengl/resources.h"
#include "harness/backend/opengl/timing.h"

namespace lamina::gl {

struct Resources {
  Table<TextureId, Texture> textures{"texture"};
  Table<BufferId, Buffer> buffers{"buffer"};
  Table<PipelineId, Pipeline> pipelines{"pipeline"};
  Samplers samplers;
  Framebuffers framebuffers;
};

// As Backend::run says.
RunTimes run_passes(Resources& resources, PassTimer& timer, std::span<const Pass> passes, Timing timing);

}  // namespace lamina::gl
