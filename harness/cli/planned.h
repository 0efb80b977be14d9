// SPDX-License-Identifier: Apache-2.0
// The plan as the record has it.
#pragma once

#include "harness/cli/options.h"
#include "harness/graph/graph.h"
#include "harness/record/plan_row.h"

namespace lamina {

// Each effect with called_for and why, its features, the passes of every variant, and the frame in which every effect stands as
// it is chosen, with its targets. Throws Error(bad_input) for a mistake of a manifest; what cannot run otherwise has its
// reason.
PlanRow plan_row(const Plan& plan, const Scene& scene, ShaderCache& shaders, const FrameSize& size);

}  // namespace lamina
