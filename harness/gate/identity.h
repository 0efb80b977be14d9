// SPDX-License-Identifier: Apache-2.0
// Whether a variant is the same in two trees. Byte-identical code on one driver cannot differ in time, so timing it could only
// raise false alarms. The same holds for the passes of a frame before the first one whose code differs.
#pragma once

#include <string>
#include <vector>

#include "harness/graph/graph.h"

namespace lamina {

struct Identity {
  std::string whole;  // a hash over the manifests of the variant and its effect, as bytes, and what is done once
  std::vector<std::string> frame_passes;  // a hash over the compiled shaders of each pass of the frame, in order
  std::string truth;                      // a hash over the passes for the truth
  bool operator==(const Identity&) const = default;
};
// `truth` is the variant's graph of that purpose, or null where it has none.
Identity identity_of(const VariantManifest& variant, const Graph& graph, const Graph* truth);

// How many passes from the frame's first on are the same, and so is all that they read.
size_t same_passes(const Identity& a, const Identity& b);

}  // namespace lamina
