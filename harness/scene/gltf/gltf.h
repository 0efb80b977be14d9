// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 model as objects: its scene's nodes, each primitive with triangles an object of its own, named after its node (or
// mesh), with the look of its material. Skins and morph targets stand in their rest pose;
// animations, cameras and lights are left out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

struct LoadedModel {
  std::vector<Object> objects;  // at least one; effects and unwrap_problem are not settled: see load_scene.cpp
  std::vector<std::string> warnings;
};

// Throws Error(bad_input) naming the file, mesh or material.
LoadedModel load_gltf(const std::filesystem::path& file);

}  // namespace lamina
