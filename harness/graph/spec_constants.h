// SPDX-License-Identifier: Apache-2.0
// The specialization constants of a draw: what a manifest's pass gives, or the variant's parameters by their defaults, or the
// values that a run sets, later ones over earlier ones.
#pragma once

#include <vector>

#include "harness/backend/backend.h"
#include "harness/graph/frame.h"

namespace lamina {

// Of all stages, those that have a value; others keep the shader's own. Throws Error(bad_input, "variants", the pass's place)
// for text that is neither a number nor true or false.
std::vector<SpecConstant> spec_constants(const GraphPass& pass, const GraphDraw& draw, const Parameters& parameters);

}  // namespace lamina
