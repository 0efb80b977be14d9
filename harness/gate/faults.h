// SPDX-License-Identifier: Apache-2.0
// Faults that the gate claims to catch, put into a variant in memory.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/graph/shader_cache.h"
#include "harness/manifest/library.h"

namespace lamina {

// Where a fault goes.
struct FaultSite {
  VariantManifest& variant;
  PassManifest& pass;              // of the variant: it writes the frame
  const CompiledShader& compiled;  // its fragment shader
  std::filesystem::path folder;    // for shaders that are written
  ShaderCache::Change& change;     // of compiled shaders
};

struct Fault {
  std::string name, title;
  // What it changes. A fault of pictures that changes no bit of them, where code that no pixel runs is changed, is not there.
  enum class Of : uint8_t { picture, alpha, work } of = Of::picture;
  std::function<std::string(const FaultSite&)> put;  // returns "" or why it cannot be put there
};

// In the order of their cost to a reader: what draws nothing first.
const std::vector<Fault>& gate_faults();

}  // namespace lamina
