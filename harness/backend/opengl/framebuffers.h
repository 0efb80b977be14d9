// SPDX-License-Identifier: Apache-2.0
// Framebuffers, made when a set of attachments is first drawn into.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "harness/backend/common/table.h"
#include "harness/backend/opengl/resources.h"

namespace lamina::gl {

// One framebuffer for each set of attachments that was ever drawn to, until one of its textures goes.
class Framebuffers {
 public:
  // Of a pass that check_targets() lets through. Throws Error(failed) where the driver finds the set incomplete.
  GLuint of(const Pass& pass, Table<TextureId, Texture>& textures);
  void forget(TextureId texture);

 private:
  struct Key {
    std::vector<std::pair<TextureId, uint32_t>> attachments;  // texture and level, depth last
    bool depth = false;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, FramebufferObject> framebuffers_;
};

}  // namespace lamina::gl
