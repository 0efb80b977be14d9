// SPDX-License-Identifier: Apache-2.0
// Whether a variant is the same in two trees. What a device executes alike cannot differ in time, so timing it could only raise
// false alarms. The same holds for the passes of a frame before the first one that differs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/graph/graph.h"

namespace lamina {

struct Identity {
  std::string whole;  // a hash over what the manifests of the variant and its effect say, and what is done once
  std::vector<std::string> frame_passes;  // a hash over what each pass of the frame executes, in order
  std::string truth;                      // a hash over what the passes for the truth execute
  bool operator==(const Identity&) const = default;
};

// Hashes over the executable form of shaders. Two trees have most modules in common, so each module's is made once.
class CodeHashes {
 public:
  const std::string& of(const CompiledShader& shader, Api api);

 private:
  std::map<std::string, std::string> known_;  // by API and a hash over the module
};

// `truth` is the variant's graph of that purpose, or null where it has none.
Identity identity_of(const VariantManifest& variant, const Graph& graph, const Graph* truth, Api api, CodeHashes& hashes);

// How many passes from the frame's first on are the same, and so is all that they read.
size_t same_passes(const Identity& a, const Identity& b);

}  // namespace lamina
