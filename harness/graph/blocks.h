// SPDX-License-Identifier: Apache-2.0
// What the uniform blocks of a draw hold: Frame (camera, lights, sizes, time), Object (its transforms), Effect (the numbers and
// words that its effect declares) and Pass (which repetition it is). docs/manifest.md lists the members.
#pragma once

#include <optional>

#include "harness/graph/block_values.h"
#include "harness/manifest/library.h"
#include "harness/scene/scene.h"

namespace lamina {

struct BlockContext {
  const Scene& scene;
  const Library& library;
  const EffectManifest& effect;
  std::string where;  // of the pass, for messages
  size_t view = 0;
  PassView from = PassView::eye;
  std::optional<size_t> light;   // of the scene, that the pass is drawn for
  std::optional<size_t> object;  // of the scene; none: a pass of the whole frame
  uint32_t width_px = 1, height_px = 1;
  glm::ivec4 iteration{0, 1, 0, 0};
};

// The scene's lights that cast, by index.
std::vector<size_t> casting_lights(const Scene& scene);

// The values of all members that the block may declare. What takes long to compute is set only where the block declares it.
// Throws Error(bad_input) naming the pass: for a block of another name, for a block of an object in a pass of the whole frame,
// for a light inside the scene, since no one view shows everything that it lights.
BlockValues block_values(const ShaderResource& block, const BlockContext& context);

}  // namespace lamina
