// SPDX-License-Identifier: Apache-2.0
// What a frame's targets are for: which passes write each and which read it, and what it takes. No device is needed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/graph/graph.h"

namespace lamina {

// A target or storage buffer, with those of its name that objects or lights have of their own.
struct TargetUse {
  const VariantManifest* variant = nullptr;  // whose it is; null: shared, or the frame's own picture or depth
  std::string name;                          // "frame" and "depth" are the frame's own
  bool shared = false;
  size_t copies = 1;                     // one for each object or light that has one
  std::vector<size_t> writers, readers;  // passes of the graph by index, ascending; storage buffers are in both
  uint64_t bytes = 0;                    // of all copies and both buffers of each, as their formats say
};

// The frame's own two first, then the others as passes come to them. Their bytes add up to what Frame::target_bytes() of a
// timed build says.
std::vector<TargetUse> target_uses(const Graph& graph, const Scene& scene, uint32_t width_px, uint32_t height_px);

}  // namespace lamina
