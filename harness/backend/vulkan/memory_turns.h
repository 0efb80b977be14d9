// SPDX-License-Identifier: Apache-2.0
// Which of the textures that share memory holds it, from pass to pass. A texture that comes into its memory loses what it held,
// and takes what the others held that lie there too.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "harness/backend/vulkan/resources.h"

namespace lamina::vulkan {

class MemoryTurns {
 public:
  explicit MemoryTurns(Resources& resources) : resources_(resources) {}

  // The next pass in order, which uses these textures. Returns those of them that come into their memory: their levels have no
  // layout any more. Throws Error(bad_input) naming the pass where it needs a level that holds nothing. A storage image that a
  // shader writes counts as filled.
  std::vector<TextureId> next(const Pass& pass, const std::set<TextureId>& used);
  // What next() was told is done.
  void commit();

 private:
  SharedMemory::Place* place_of(TextureId id, const Pass& pass);
  void need(TextureId id, std::optional<uint32_t> level, const Pass& pass);
  void fill(TextureId id, uint32_t level, const Pass& pass);

  Resources& resources_;
  std::map<std::shared_ptr<SharedMemory>, std::vector<SharedMemory::Place>> places_;  // after the passes told
};

}  // namespace lamina::vulkan
