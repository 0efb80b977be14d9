// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "harness/graph/graph.h"
#include "harness/plan/everything.h"

namespace lamina {

// The passes of the frame in which everything runs that can, those included that nothing reads or that another effect has drawn
// already. An effect that has no part in it after all is taken out of `plan`, with the reason in `plan.cannot`: none of its
// passes draws anything in this scene, or it cannot be made ready for it. Throws as make_graph() for what the scene calls for
// by `called_for`, its own plan.
Graph make_graph_of_everything(EverythingPlan& plan, const Plan& called_for, const Scene& everything, ShaderCache& shaders,
                               const Parameters& parameters = {});

}  // namespace lamina
