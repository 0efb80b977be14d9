// SPDX-License-Identifier: Apache-2.0
// Framebuffers, made when a set of attachments is first drawn into.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "harness/backend/opengl/resources.h"

namespace lamina::gl {

// One framebuffer for each set of attachments that was ever drawn to, until one of its textures goes.
class Framebuffers {
 public:
  struct Target {
    GLuint name = 0;
    uint32_t width = 0, height = 0;  // pixels
  };
  // Throws Error(bad_input) about the pass where it has no attachments or their sizes differ, Error(failed) where the driver
  // finds the set incomplete.
  Target of(const Pass& pass, Table<TextureId, Texture>& textures);
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
