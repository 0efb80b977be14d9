// SPDX-License-Identifier: Apache-2.0
// Cache keys of what passes take from a scene's numbers. After some numbers changed, they show what must be done again. Of
// every uniform block only the members that the shaders' code reads (by reflection) count.
#pragma once

#include <string>

#include "harness/graph/graph.h"

namespace lamina {

// Equal keys mean equal results, as long as textures, variants' parameters and the size of the frame are equal too.
// Of the passes done once.
std::string once_inputs(const Graph& graph, const Scene& scene);
// Of which fragments the frame's passes shade, in all views. `early_tests`: no shader discards or writes depth. Then only
// vertex shaders decide, unless one of them reads what other passes write.
std::string coverage_inputs(const Graph& graph, const Scene& scene, bool early_tests);

}  // namespace lamina
