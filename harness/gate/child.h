// SPDX-License-Identifier: Apache-2.0
// Work done in a process of its own, so that measurements do not share a memory layout, two OpenGL contexts never meet, and a
// driver that crashes takes nothing with it.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

namespace lamina {

using EmitLine = std::function<void(const nlohmann::ordered_json&)>;

struct ChildResult {
  std::vector<nlohmann::json> lines;
  std::string failure;  // "" where it ended well: an error's words, or the signal that ended it
};

// Forks a child for each; it hands its lines over one by one; what it throws becomes the failure. All run at the same time.
// The parent must have no threads and no open backend. While StopSignals live, what asks this process to stop asks the children
// too: they inherit them, and their work is to heed them. Throws Error(failed) where no process can be made.
std::vector<ChildResult> run_in_children(const std::vector<std::function<void(const EmitLine&)>>& works);
// The same for one.
ChildResult run_in_child(const std::function<void(const EmitLine&)>& work);

}  // namespace lamina
