// SPDX-License-Identifier: Apache-2.0
// The passes of a frame as OpenGL calls.
#pragma once

#include <span>

#include "harness/backend/opengl/prepare.h"
#include "harness/backend/opengl/sample_counts.h"
#include "harness/backend/opengl/timing.h"

namespace lamina::gl {

// As Backend::run says.
RunTimes run_passes(Resources& resources, PassTimer& timer, SampleCounts& samples, std::span<const Pass> passes, Timing timing);

}  // namespace lamina::gl
