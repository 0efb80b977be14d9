// SPDX-License-Identifier: Apache-2.0
// Typed handles: an index that cannot be mistaken for another kind of index.
#pragma once

#include <compare>
#include <cstdint>

namespace lamina {

template <class Tag>
struct Id {
  static constexpr uint32_t none = 0xffffffffu;
  uint32_t value = none;
  explicit operator bool() const { return value != none; }
  auto operator<=>(const Id&) const = default;
};

using TextureId = Id<struct TextureTag>;
using BufferId = Id<struct BufferTag>;
using PipelineId = Id<struct PipelineTag>;

}  // namespace lamina
