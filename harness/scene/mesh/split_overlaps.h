// SPDX-License-Identifier: Apache-2.0
// A mesh whose parts share texels (mirrored halves, say) has no unique unwrap: what is drawn into its texture shows one part's
// light on all of them. Taken apart into meshes that share none, each can have a light map of its own.
#pragma once

#include <vector>

#include "harness/manifest/library.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/scene.h"

namespace lamina {

// Maximum number of meshes that one is taken apart into; parts that still overlap stay together in the last one.
inline constexpr size_t max_parts = 8;

// Charts (triangles joined by vertices) are put, in order, into the first part in which they cover hardly any texel again. The
// mesh itself where its charts share none. Triangles keep their order within a part; vertices that no part uses are dropped.
std::vector<Mesh> split_overlaps(const Mesh& mesh);

// The same for every object of an effect with unique_unwrap: the parts are called NAME, NAME.2, NAME.3 ... Says so in
// `warnings`.
void split_overlapping_objects(std::vector<Object>& objects, const Library& library, OverlapFractions& overlaps,
                               std::vector<std::string>& warnings);

// Whether the object lays something out over its unwrap: by an effect with unique_unwrap, or by a number with over_unwrap above
// 0.
bool uses_unwrap(const Object& object, const Library& library);

}  // namespace lamina
