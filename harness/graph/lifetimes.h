// SPDX-License-Identifier: Apache-2.0
// When each target of a frame is needed, and which must keep its memory. No device is needed.
#pragma once

#include <string>
#include <vector>

#include "harness/graph/frame_passes.h"

namespace lamina {

struct TargetLife {
  std::optional<Lifetime> lifetime;  // over the passes done once, then those of the frame, in order
  std::string kept;                  // why it has none; "" where it has one
};

// Of each of the targets' textures. One has a lifetime where nothing asks for what it holds before and after: passes of one
// sequence alone use it, each level is cleared, overwritten by a full-screen pass, copied or generated before anything needs
// it, and this is never left out while what needs it runs. Kept are the frame's own buffers, which are read back; what is drawn
// once and read in frames; and what a shader writes as an image, for it need not write all.
std::vector<TargetLife> target_lives(const FramePasses& passes);

// The targets' textures as a backend takes them.
std::vector<TransientDesc> transient_targets(const FramePasses& passes);

// Bytes of all targets as their formats say; a driver may pad them.
struct TargetMemory {
  uint64_t alone = 0;    // each has memory of its own
  uint64_t aliased = 0;  // those needed at different times lie in one memory
  uint64_t reused = 0;   // those needed at different times are one texture where they are alike
};
TargetMemory target_memory(const FramePasses& passes);

}  // namespace lamina
