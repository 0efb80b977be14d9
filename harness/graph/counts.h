// SPDX-License-Identifier: Apache-2.0
// What a pass executed, as its counting build counted it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "harness/shader/block_work.h"

namespace lamina {

// Texture operations on one texture.
struct TextureFetches {
  std::string texture;  // the sampler's name in the shader
  std::string format;   // "rgba8_srgb"
  std::string filter;   // "trilinear"
  uint64_t fetches = 0;
  uint64_t issued = 0;  // likewise of the untaken side of branches (shader/block_work.h)
};

struct PassCounts {
  uint64_t vertices = 0;    // invocations of the vertex shader
  uint64_t fragments = 0;   // invocations of the fragment shader, or of the compute shader
  bool early_tests = true;  // false: some shader discards or writes depth, so fragments hidden later are counted too
  std::vector<TextureFetches> by_texture;
  std::map<std::string, uint64_t> operations;  // by the name of the class (shader/operations.h), of all stages
  std::map<std::string, uint64_t> issued;      // likewise of what is issued, the untaken side of branches too
  std::map<SourceLine, LineWork> lines;        // likewise; files are relative to the folder of shaders where they lie in it

  uint64_t fetches() const {
    uint64_t sum = 0;
    for (const TextureFetches& texture : by_texture) sum += texture.fetches;
    return sum;
  }
};

}  // namespace lamina
