// SPDX-License-Identifier: Apache-2.0
// What a pass executed, as its counting build counted it, and what it is made of.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
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
  // What records of before lack.
  std::optional<uint64_t> unfiltered = {};  // of the fetches, those of single texels (texelFetch), whatever the filter
  std::optional<uint64_t> dimensions = {};  // 2 or 3
  std::vector<uint64_t> size = {};          // of level 0 in texels: width, height, and a 3D texture's depth
  // levels[k]: how often level k was read; a fetch between two levels reads both. Levels are the texture's own, also where the
  // shader sees one of them as its level 0. Empty where they are not counted (shader/level_reads.h).
  std::vector<uint64_t> levels = {};
};

// The mean level of the reads that `levels` counts, as in TextureFetches; absent where there are none.
std::optional<double> mean_level(const std::vector<uint64_t>& levels);

// What a pass writes by one attachment, or by filling mips or copying.
struct WrittenTexels {
  std::string format;   // "rgba16_float"
  std::string load;     // of what is there: "clear", "keep", "discard"; or "mips", "copy"
  std::string combine;  // with what is there: a blend ("none", "alpha", ...); of depth "test" or "test and write"
  uint64_t texels = 0;  // that the attachment has, drawn or not, over all runs
};

struct PassCounts {
  uint64_t vertices = 0;    // invocations of the vertex shader
  uint64_t fragments = 0;   // invocations of the fragment shader, or of the compute shader
  bool early_tests = true;  // false: some shader discards or writes depth, so fragments hidden later are counted too
  std::vector<TextureFetches> by_texture;
  std::map<std::string, uint64_t> operations;     // by the name of the class (shader/operations.h), of all stages
  std::map<std::string, uint64_t> issued;         // likewise of what is issued, the untaken side of branches too
  std::map<std::string, uint64_t> vertex_issued;  // of those, the vertex stage's
  std::map<SourceLine, LineWork> lines;           // likewise; files are relative to the folder of shaders where they lie in it
  uint64_t runs = 0;                              // of the device's passes: one a repetition, and one an object or light
  uint64_t triangles = 0;                         // that were drawn, seen or not
  std::optional<uint64_t> issued_fragments;       // Pass::count_issued_fragments; absent where the device does not tell
  std::vector<WrittenTexels> written;

  uint64_t fetches() const {
    uint64_t sum = 0;
    for (const TextureFetches& texture : by_texture) sum += texture.fetches;
    return sum;
  }
};

}  // namespace lamina
