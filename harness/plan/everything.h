// SPDX-License-Identifier: Apache-2.0
// The frame in which everything runs that can, whether the scene calls for it or not: what the frame of a plan is held against.
// Its picture is the same, bit for bit.
#pragma once

#include <map>
#include <string>

#include "harness/plan/plan.h"

namespace lamina {

// The scene with values for every effect of the library: what it does not speak of, or not so that it calls for it, has its
// defaults, but 0 for the first number that takes the effect away. The library must be the one that it was loaded with.
Scene scene_of_everything(const Scene& scene, const Library& library);

struct EverythingPlan {
  Plan plan;                                    // of scene_of_everything(), culling off, each effect at `plan`'s variant
  std::map<std::string, std::string> cannot{};  // by effect: why it has no part in it
};
// `plan`: the scene's own. An effect of the whole scene that no number takes away, and that the scene does not speak of, has no
// part in it. The plan points into the library.
EverythingPlan plan_of_everything(const Plan& plan, const Scene& everything);

}  // namespace lamina
