// SPDX-License-Identifier: Apache-2.0
// A texture whose reads a pass counts, and its row of counts.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "harness/graph/counts.h"
#include "harness/shader/level_reads.h"

namespace lamina {

struct CountedTexture {
  TextureFetches row;       // without counts
  LeveledTexture leveled;   // as the shader sees it
  uint32_t base_level = 0;  // of the texture, that the shader sees as level 0
};

// `size`: of the texture's level 0. `level`: the one that the shader sees, where it sees one only.
CountedTexture counted_texture(std::string sampler, Filter filter, Format format, std::array<uint32_t, 3> size, uint32_t levels,
                               std::optional<uint32_t> level);

// What tells counted textures apart: draws whose textures are alike in it share a pipeline and its counters.
std::string key_of(const CountedTexture& texture);

// Gathers rows: what is alike in name, format, filter and size is one.
class FetchesByTexture {
 public:
  explicit FetchesByTexture(std::vector<TextureFetches>& rows) : rows_(rows) {}
  // What a stage did to the texture at `binding`.
  void add(const CountedTexture& texture, uint32_t binding, const ShaderWork& done, const ShaderWork& issued);

 private:
  std::vector<TextureFetches>& rows_;
  std::set<size_t> without_levels_;  // rows that some read's level is not known of
};

}  // namespace lamina
