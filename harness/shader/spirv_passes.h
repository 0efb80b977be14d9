// SPDX-License-Identifier: Apache-2.0
// Rewriting a module by passes of SPIRV-Tools.
#pragma once

#include <spirv-tools/optimizer.hpp>
#include <string_view>
#include <vector>

#include "harness/backend/backend.h"

namespace lamina {

// All functions become part of main. The inliner leaves alone what returns early, so those returns go first.
void register_inlining(spvtools::Optimizer& optimizer);

// What is run for modules of this API.
spvtools::Optimizer optimizer_for(Api api);

// `words` after the registered passes, not validated. Throws Error(failed, "shader", subject) with the words of SPIRV-Tools.
std::vector<uint32_t> rewrite(spvtools::Optimizer& optimizer, const std::vector<uint32_t>& words, std::string_view subject);

}  // namespace lamina
