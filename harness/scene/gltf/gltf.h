// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 model as objects: its scene's nodes, each primitive with triangles an object of its own, named after its node (or
// mesh), with the look of its material. With a time its first animation is played to that
// moment: nodes, skins and morph targets. Without one they stand in their rest pose. Cameras and lights are left out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct LoadedModel {
  std::vector<Object> objects;  // at least one; effects and unwrap_problem are not settled: see load_scene.cpp
  std::vector<std::string> warnings;
  bool mesh_moves = false;    // the animation changes a mesh that is drawn, by a skin or by morph targets
  bool objects_move = false;  // or the place of one
};

// Throws Error(bad_input) naming the file, mesh, material or animation.
LoadedModel load_gltf(const std::filesystem::path& file, std::optional<double> time_s = std::nullopt);

}  // namespace lamina
